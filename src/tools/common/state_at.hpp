#pragma once

#include <cstdint>
#include <functional>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// What is to be done at every step of a run.
struct StepHooks {
  std::function<void()> before;  ///< also before a state within a step; may come twice for one step
  std::function<void(double t)> within;  ///< between `before` and a state at t [s] within the step,
                                         ///< or the step itself, with the time that it reaches
  std::function<State(double t)> sample;  ///< the state at t [s] within the step; none: sample()
  std::function<void()> after;
  /// How many steps may be taken at once, one at least, as there is nothing to be done between
  /// them: asked after `before` and `within`, of which the latter was told the end of the first.
  /// None: one, where there is anything of the above.
  std::function<std::int64_t()> free_steps;
};

/// The number of the last step that is at time t [s], which may be infinite, or before.
std::int64_t stepsBy(const Simulation& simulation, double t);

/// Steps as far as whole steps go towards a time. Returns whether that is there, an instant that a
/// step misses by rounding being that step's; else it is within the next step, for sample().
bool stepTo(Simulation& simulation, double t, const StepHooks& hooks = {});

/// The state at time t, to which the simulation is stepped as far as whole steps go. An instant
/// that a step misses by rounding is that step's.
State stateAt(Simulation& simulation, double t, const StepHooks& hooks = {});

/// The same as far as time and bodies go, which of many bodies costs a fraction of it; what else a
/// state says may be missing.
State bodiesAt(Simulation& simulation, double t, const StepHooks& hooks = {});

}  // namespace rigid_body_sim
