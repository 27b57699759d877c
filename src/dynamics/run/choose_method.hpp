#pragma once

#include <limits>
#include <vector>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/run/coupling.hpp"

namespace rigid_body_sim {

/// A row of the catalogue and the equal parts in which it takes each time step.
struct MethodChoice {
  const Method* method = nullptr;  ///< null: the motion is solved
  int parts = 1;
  double error = 0;            ///< what the trial found, as a share of the tolerance
  double most_turn_share = 1;  ///< of the turn that the method follows in one part
  bool holds = true;           ///< whether any row was found to hold the tolerance
  /// [s] Up to when the motion was tried; for one that was not tried, nothing depends on it.
  double tried_until = std::numeric_limits<double>::infinity();
  bool cut_short = false;   ///< whether that is before the world's horizon
  bool controlled = false;  ///< whether the method's own estimates part its steps to hold the
                            ///< tolerance
};

/// What follows any motion within the tolerance, at a higher price than what a trial finds: dop853
/// with steps parted by its error estimates.
MethodChoice controlledChoice();

/// The cheapest row and number of parts with which bodies that act on one another hold the world's
/// tolerance over its horizon, or controlledChoice() where none was found to hold it; found by
/// trying them from the given states on, against dop853 at steps so short that it agrees with
/// itself. The cost is counted, not timed, so that the same scene always chooses the same.
/// most_body_steps: bounds the work of one run of the trial; one cut short in time must do better
/// by the square of what it was cut, since attitude errors grow up to quadratically.
MethodChoice chooseMethod(const World& world, const CoupledBodies& group, const State& state,
                          const std::vector<WrenchSchedule>& schedules, double most_body_steps);

}  // namespace rigid_body_sim
