#include "state_at.hpp"

#include <cmath>
#include <cstdint>

namespace rigid_body_sim {

State stateAt(Simulation& simulation, double t, const StepHooks& hooks) {
  const double h = simulation.world().solver.time_step;
  const auto whole_steps = static_cast<std::int64_t>(std::floor(t / h + 1e-6));
  while (simulation.steps() < whole_steps) {
    if (hooks.before) hooks.before();
    simulation.step();
    if (hooks.after) hooks.after();
  }
  if (t - simulation.time() < 1e-6 * h) return simulation.state();
  if (hooks.before) hooks.before();
  return simulation.sample(t);
}

}  // namespace rigid_body_sim
