#include "dynamics/actuators/actuator_start.hpp"

#include <algorithm>

#include "dynamics/actuators/actuator_table.hpp"

namespace rigid_body_sim {

bool hasActuators(const World& world) {
  return std::any_of(world.bodies.begin(), world.bodies.end(),
                     [](const Body& body) { return !body.actuators.empty(); });
}

Vector3d totalMomentum(const BodyState& state, const Vector3d& H_P) {
  return rotate(state.q_WP, Vector3d(state.L_P + H_P));
}

State withActuators(const World& world, State state) {
  if (!state.actuators.empty() || !hasActuators(world)) return state;
  state.actuators.resize(world.bodies.size());
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    if (body.actuators.empty()) continue;
    const ActuatorTable table = actuatorTable(body);
    const Vector3d w_P = angularVelocity(body.inv_I, state.bodies[i].L_P);
    state.actuators[i] = startOf(table, w_P, state.t);
    if (!hasSpin(table)) continue;
    state.bodies[i].L_W =
        totalMomentum(state.bodies[i], momentumOf(table, state.actuators[i], state.t));
  }
  return state;
}

}  // namespace rigid_body_sim
