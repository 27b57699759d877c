#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

double mechanicalEnergy(const World& world, const State& state) {
  std::vector<const Body*> bodies;
  double energy = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    bodies.push_back(&body);
    if (body.fixed) continue;
    energy += kineticEnergy(body, state.bodies[i]) -
              body.mass * world.g_W.dot(state.bodies[i].x_W + state.bodies[i].x_low_W);
  }
  for (const auto& law : world.laws) energy += law->potentialEnergy({bodies, state.bodies});
  return energy;
}

}  // namespace rigid_body_sim
