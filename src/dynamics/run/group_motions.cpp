#include "dynamics/methods/accelerations.hpp"
#include "dynamics/run/group.hpp"

/// How the bodies of a group accelerate.
namespace rigid_body_sim {

std::vector<BodyMotion> Group::motions(double t) const {
  SystemState states = present_;
  if (solved_ && t != t_) states.bodies[0] = solved_->at(t);
  setClocks(t, states.laws);
  std::vector<BodyMotion> motions = motionsOf(system_, states);
  if (!isAtRest()) return motions;
  // they stay where they are, though the laws balance to no more than a bound
  for (BodyMotion& motion : motions) {
    motion.acceleration.felt_W = -motion.acceleration.g_W;
    motion.acceleration.w_dot_P.setZero();
  }
  return motions;
}

}  // namespace rigid_body_sim
