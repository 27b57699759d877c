#pragma once

#include <functional>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// What is to be done at every step of a run.
struct StepHooks {
  std::function<void()> before;  ///< also before a state within a step; may come twice for one step
  std::function<void(double t)> within;  ///< between `before` and a state at t [s] within the step,
                                         ///< or the step itself, with the time that it reaches
  std::function<void()> after;
};

/// Steps as far as whole steps go towards a time. Returns whether that is there, an instant that a
/// step misses by rounding being that step's; else it is within the next step, for sample().
bool stepTo(Simulation& simulation, double t, const StepHooks& hooks = {});

/// The state at time t, to which the simulation is stepped as far as whole steps go. An instant
/// that a step misses by rounding is that step's.
State stateAt(Simulation& simulation, double t, const StepHooks& hooks = {});

}  // namespace rigid_body_sim
