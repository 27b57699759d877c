#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "dynamics/run/check_input.hpp"
#include "dynamics/run/parts.hpp"
#include "dynamics/world_changes.hpp"

/// Mass properties of bodies as they are set from outside.
namespace rigid_body_sim {
namespace {

/// Symmetric to the last bit, as messages and files have it.
MassProperties symmetric(MassProperties properties) {
  properties.I_Bcm = properties.I_Bcm.selfadjointView<Eigen::Upper>();
  return properties;
}

/// [J], [m/s] and [rad/s] of a body that has become very light or heavy may be too great for
/// numbers.
void requireFiniteMotion(const World& world, std::size_t i, const State& state) {
  const Body& body = world.bodies[i];
  const BodyFrameMotion motion = toBodyFrameMotion(body, state.bodies[i]);
  if (!motion.v_W.allFinite() || !motion.w_W.allFinite() ||
      !std::isfinite(mechanicalEnergy(world, state)))
    throw std::invalid_argument("body '" + body.name +
                                "': with the momenta that it keeps, velocities and energy would "
                                "not be finite; another mass or inertia is needed");
}

}  // namespace

/// The run goes on from its own state, in a world in which the body is another: what is fixed to
/// the body is given in its new principal frame, and other groups keep their bits, as after load().
void Run::setMassProperties(std::size_t body, const MassProperties& properties_B) {
  Run changed = *this;
  changed.now_.unpack(body);
  changed.grouping_.disturb(changed.now_, body);
  changed.restartGroup(body);
  State state = changed.state();
  state.changes.resize(now_.world->bodies.size());
  state.changes[body].properties_B = properties_B;
  changed.enter(state.changes);
  const Body& before = now_.world->bodies[body];
  const Body& after = changed.now_.world->bodies[body];
  state.bodies[body] = keepingMomentum(before, after, state.bodies[body]);
  requireFiniteMotion(*changed.now_.world, body, state);
  constexpr double kNotSolved = -std::numeric_limits<double>::infinity();
  state.anchors[body] = {state.t, state.bodies[body], kNotSolved};
  for (BodySchedule& schedule : state.schedules)
    for (ScheduledWrench& entry : schedule.wrenches) reframe(entry.wrench, body, before, after);
  goOnAs(changed, state);
  contacts_.follow(now_, grouping_, body);
}

void Simulation::setMassProperties(std::size_t body, const MassProperties& properties_B) {
  checkBody(world(), body);
  const std::string fault = massPropertiesFault(properties_B);
  if (!fault.empty())
    throw std::invalid_argument("body '" + world().bodies[body].name + "': " + fault);
  const Totals before = parts_->balance ? totalsOf(world(), state()) : Totals();
  parts_->run.setMassProperties(body, symmetric(properties_B));
  if (parts_->balance)
    parts_->balance->addChange(before, totalsOf(world(), state()), world().bodies[body].pivoted);
  if (parts_->error) parts_->error->restart();
}

}  // namespace rigid_body_sim
