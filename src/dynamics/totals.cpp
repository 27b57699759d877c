#include <limits>

#include <rigid_body_sim/dynamics/totals.hpp>

#include "dynamics/actuators/actuator_start.hpp"
#include "dynamics/state_of_world.hpp"

namespace rigid_body_sim {

Totals Totals::unknown() {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  return {kNaN, Vector3d::Constant(kNaN), Vector3d::Constant(kNaN)};
}

Totals totalsOf(const World& world, const State& state) {
  requireStateOf(world, state);
  if (state.actuators.empty() && hasActuators(world))
    return totalsOf(world, withActuators(world, state));
  Totals sum;
  sum.energy = mechanicalEnergy(world, state);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!moves(world.bodies[i])) continue;
    const BodyState& body = state.bodies[i];
    const Vector3d p_W = momentumOf(world.bodies[i], body);
    sum.momentum += p_W;
    sum.angular_momentum += body.L_W + Vector3d(body.x_W + body.x_low_W).cross(p_W);
  }
  return sum;
}

}  // namespace rigid_body_sim
