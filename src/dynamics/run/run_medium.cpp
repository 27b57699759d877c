#include <stdexcept>

#include "dynamics/run/parts.hpp"
#include "math/shortest.hpp"

/// The velocity of the medium as it is set from outside.
namespace rigid_body_sim {

/// It is a state of the laws of drag. Those of solved bodies enter their solution, so that their
/// groups form anew.
void Run::setWind(const Vector3d& velocity_W) {
  now_.law_states = now_.lawStates();
  std::vector<std::size_t> bodies;
  for (std::size_t i = 0; i < now_.world->laws.size(); ++i) {
    const ForceLaw& law = *now_.world->laws[i];
    if (!law.setMedium(velocity_W, now_.law_states.data() + now_.laws.firstState(i))) continue;
    for (std::size_t body : law.members()) {
      if (!moves(now_.world->bodies[body])) continue;
      grouping_.disturb(now_, body);
      restartGroup(body);
      bodies.push_back(body);
    }
  }
  if (!bodies.empty()) grouping_.regroup(now_, bodies, now_.time, true);
}

void Simulation::setWind(const Vector3d& velocity_W) {
  if (!world().has_medium)
    throw std::invalid_argument("wind needs a medium, and the scene names none");
  if (!velocity_W.allFinite())
    throw std::invalid_argument("the velocity of the wind must be finite, got " +
                                shortest(velocity_W) + " m/s");
  parts_->run.setWind(velocity_W);
  if (parts_->error) parts_->error->restart();
}

}  // namespace rigid_body_sim
