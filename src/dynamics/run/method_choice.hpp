#pragma once

#include <limits>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/run/contact_bound.hpp"

namespace rigid_body_sim {

/// How bodies that act on one another are advanced; as MotionPlan, in the terms of the run.
struct MethodChoice {
  const Method* method = nullptr;  ///< null: the motion is solved
  int substeps = 1;                ///< equal substeps of each time step, at least
  double error = 0;                ///< what the trial found, as a share of the tolerance
  double max_turn_share = 1;       ///< of Method::max_turn that a substep may turn by
  bool holds = true;               ///< whether any integrator was found to hold the tolerance
  /// [s] End of the trial; ∞ if none.
  double tried_until = std::numeric_limits<double>::infinity();
  bool cut_short = false;     ///< whether that is before the world's horizon
  bool by_estimates = false;  ///< the integrator's own estimates divide its steps so that the
                              ///< tolerance is held
  double bound_share = 1;     ///< of what stepBound allows the estimate of a step to be
  double contact_bound = 0;   ///< what the error estimate of a step in contact may reach; 0: as
                              ///< contactStepBound says
  double contact_work = kMaxContactWork;  ///< see maxContactWork
  double event_work = 1e7;                ///< evaluations of all forces that a step may take, with
                                          ///< those by which its events out of contact are located:
                                          ///< ten thousand events, seconds of one body
  bool read_once = false;                 ///< of a solved motion: see SolvedProblem
};

/// How a run differs that is compared with another.
struct Beside {
  int steps = 1;             ///< of the other that are one of its own
  double turn_share = 1;     ///< what MethodChoice::max_turn_share is multiplied by
  double bound_share = 1;    ///< what MethodChoice::bound_share is
  double contact_share = 1;  ///< what MethodChoice::contact_bound is
  int least_substeps = 1;    ///< of a step that is divided by error estimates
};

MethodChoice changedBy(const Beside& beside, const MethodChoice& choice);

/// What follows any motion within the tolerance, at a higher price than what a trial finds: dop853
/// with steps divided by its error estimates.
MethodChoice errorControlled();

}  // namespace rigid_body_sim
