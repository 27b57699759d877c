#include "state_at.hpp"

#include <cmath>
#include <cstdint>

namespace rigid_body_sim {

State stateAt(Simulation& simulation, double t) {
  const double h = simulation.world().solver.time_step;
  const auto whole_steps = static_cast<std::int64_t>(std::floor(t / h + 1e-6));
  while (simulation.steps() < whole_steps) simulation.step();
  return t - simulation.time() < 1e-6 * h ? simulation.state() : simulation.sample(t);
}

}  // namespace rigid_body_sim
