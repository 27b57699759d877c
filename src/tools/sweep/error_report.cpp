#include "tools/sweep/error_report.hpp"

#include <algorithm>
#include <cmath>

#include <rigid_body_sim/dynamics/contact_point.hpp>

#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

/// Whether the trial of a contact has shown, up to an end [s], that the tolerance holds.
bool holdsByTrial(const ContactTrial& trial, double end) {
  return trial.is_made && trial.compares && trial.tried_until >= end && std::isinf(trial.lost_at);
}

}  // namespace

ErrorReport errorReport(const Simulation& run, double end) {
  ErrorReport report;
  const ErrorEstimate error = run.errorEstimate();
  const bool is_compared = run.steps() >= 2;
  if (is_compared && std::isfinite(error.attitude) && std::isfinite(error.position))
    report.estimate = error;
  const SolverOptions& solver = run.world().solver;
  const bool is_auto = solver.integrator == "auto";
  const ContactTrial trial = run.contactTrial();
  const std::vector<MotionPlan> plans = run.plans();
  const double lost_at = std::isfinite(error.lost_at) ? error.lost_at : trial.lost_at;
  // without contact and tethers the steps were tried beforehand, and plans say whether they hold
  if (is_auto && hasOneSidedLaw(run.world()) && lost_at <= end)
    report.doubt = "from " + shortest(lost_at) + " s on, tolerance " + shortest(solver.tolerance) +
                   " is not certain to be held: runs at other bounds of their steps differ by more";
  else if (is_auto && std::any_of(plans.begin(), plans.end(),
                                  [](const MotionPlan& plan) { return !plan.holds; }))
    report.doubt = "no integrator that was tried holds tolerance " + shortest(solver.tolerance);
  else if (is_compared && !report.estimate)
    report.doubt = "its error is unknown: a run at twice the step diverged";
  else if (!report.estimate && !(is_auto && holdsByTrial(trial, end)))
    report.doubt =
        "its error is unknown: it has fewer than two steps, of which it is estimated; take "
        "a shorter time_step";
  return report;
}

}  // namespace rigid_body_sim
