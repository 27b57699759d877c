#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/run/coupling.hpp"
#include "dynamics/run/method_choice.hpp"

namespace rigid_body_sim {

/// Where a trial starts.
struct TrialStart {
  double t;                              ///< [s]
  const std::vector<BodyState>& bodies;  ///< of the world
  const std::vector<double>& laws;       ///< State::laws
  const std::vector<WrenchSchedule>& schedules;
};

/// The cheapest integrator and number of substeps with which bodies that act on one another hold
/// the world's tolerance over its horizon, or errorControlled() where none was found to hold it;
/// found by trying them from the given states on, against dop853 at steps so short that it agrees
/// with itself. The cost is counted, not timed, so that the same scene always chooses the same.
/// max_body_steps: bounds the work of one run of the trial; one cut short in time must do better by
/// the square of what it was cut, since attitude errors grow up to quadratically.
MethodChoice chooseMethod(const World& world, const LawTable& laws, const CoupledBodies& group,
                          const TrialStart& start, double max_body_steps);

}  // namespace rigid_body_sim
