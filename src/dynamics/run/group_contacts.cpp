#include <algorithm>

#include "dynamics/run/group.hpp"

/// What a group says to those who look for contacts.
namespace rigid_body_sim {

void Group::settle() {
  NoMeter none;
  if (stepper_) stepper_->settle(system_, present_, none);
}

void Group::settle(ExchangeMeter& meter) {
  if (stepper_) stepper_->settle(system_, present_, meter);
}

bool Group::follows(std::size_t law) const {
  const auto isIn = [law](const std::vector<std::size_t>& laws) {
    return std::binary_search(laws.begin(), laws.end(), law);
  };
  return isIn(bodies_.laws) || (stepper_ && isIn(bodies_.waiting));
}

void Group::moveContactEvents(std::vector<ContactEvent>& events) {
  if (stepper_) stepper_->moveContactEvents(events);
}

std::optional<MotionBound> Group::motionBound(const std::vector<WrenchSchedule>& schedules) const {
  if (isAtRest()) {
    MotionBound rest;
    rest.until = nextEvent(schedules);
    return rest;
  }
  if (stepper_) return std::nullopt;
  const HeldWrench& held = system_.held[0];
  const Body& body = *system_.bodies[0];
  // about a point of the world the arm has no bound
  if (!held.world_point_forces.empty()) return std::nullopt;
  // nor has the precession about the momentum of wheels
  if (held.drive && held.drive->spins()) return std::nullopt;
  if (held.medium) return std::nullopt;  // nor has what drag adds up to
  MotionBound bound;
  bound.a_W = system_.g_W + held.f_W / body.mass;
  bound.a_off = held.f_P.norm() / body.mass;
  bound.torque = held.tau_W.norm() + held.tau_P.norm();
  for (const HeldWrench::BodyPointForce& applied : held.body_point_forces)
    bound.torque += applied.arm_P.norm() * applied.force_W.norm();
  if (held.drive) {
    bound.a_off += held.drive->forceBound() / body.mass;
    bound.torque += held.drive->torqueBound();
  }
  bound.until = nextEvent(schedules);
  return bound;
}

}  // namespace rigid_body_sim
