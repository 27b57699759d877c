#include "dynamics/methods/accelerations.hpp"
#include "dynamics/run/group.hpp"

/// How the bodies of a group accelerate.
namespace rigid_body_sim {

std::vector<BodyMotion> Group::motions(double t) const {
  if (isAtRest()) return restOf(system_, present_);
  SystemState states = present_;
  if (solved_ && t != t_) states.bodies[0] = solved_->at(t);
  setClocks(t, states.laws);
  return motionsOf(system_, states);
}

}  // namespace rigid_body_sim
