#include "tools/common/state_at.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rigid_body_sim {
namespace {

/// [steps] A time that misses the end of a step by rounding, that is by less, is there.
double missedBy(double steps) { return std::max(1e-9, 1e-15 * steps); }

/// The steps that may be taken at once now, at most so many.
std::int64_t stepsAtOnce(const StepHooks& hooks, std::int64_t at_most) {
  if (hooks.free_steps) return std::clamp<std::int64_t>(hooks.free_steps(), 1, at_most);
  return hooks.before || hooks.within || hooks.after ? 1 : at_most;
}

/// The state within the next step.
State sampleAt(const Simulation& simulation, double t, const StepHooks& hooks) {
  if (hooks.before) hooks.before();
  if (hooks.within) hooks.within(t);
  return hooks.sample ? hooks.sample(t) : simulation.sample(t);
}

}  // namespace

std::int64_t stepsBy(const Simulation& simulation, double t) {
  constexpr double kMax = 9e18;
  const double steps = t / simulation.world().solver.time_step;
  return static_cast<std::int64_t>(std::min(std::floor(steps + missedBy(steps)), kMax));
}

bool stepTo(Simulation& simulation, double t, const StepHooks& hooks) {
  const double h = simulation.world().solver.time_step;
  const std::int64_t whole_steps = stepsBy(simulation, t);
  while (simulation.steps() < whole_steps) {
    if (hooks.before) hooks.before();
    if (hooks.within) hooks.within(static_cast<double>(simulation.steps() + 1) * h);
    simulation.step(stepsAtOnce(hooks, whole_steps - simulation.steps()));
    if (hooks.after) hooks.after();
  }
  return t - simulation.time() < missedBy(t / h) * h;
}

State stateAt(Simulation& simulation, double t, const StepHooks& hooks) {
  return stepTo(simulation, t, hooks) ? simulation.state() : sampleAt(simulation, t, hooks);
}

State bodiesAt(Simulation& simulation, double t, const StepHooks& hooks) {
  if (!stepTo(simulation, t, hooks)) return sampleAt(simulation, t, hooks);
  State state;
  state.t = simulation.time();
  simulation.readBodies(state.bodies);
  return state;
}

}  // namespace rigid_body_sim
