#include "tools/common/state_at.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rigid_body_sim {

bool stepTo(Simulation& simulation, double t, const StepHooks& hooks) {
  const double h = simulation.world().solver.time_step;
  // a time that misses the end of a step by rounding is there
  const double missed = std::max(1e-9, 1e-15 * t / h);
  const auto whole_steps = static_cast<std::int64_t>(std::floor(t / h + missed));
  while (simulation.steps() < whole_steps) {
    if (hooks.before) hooks.before();
    if (hooks.within) hooks.within(static_cast<double>(simulation.steps() + 1) * h);
    simulation.step();
    if (hooks.after) hooks.after();
  }
  return t - simulation.time() < missed * h;
}

State stateAt(Simulation& simulation, double t, const StepHooks& hooks) {
  if (stepTo(simulation, t, hooks)) return simulation.state();
  if (hooks.before) hooks.before();
  if (hooks.within) hooks.within(t);
  return simulation.sample(t);
}

}  // namespace rigid_body_sim
