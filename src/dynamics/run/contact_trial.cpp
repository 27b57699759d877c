#include "dynamics/run/contact_trial.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/run/contact_bound.hpp"
#include "dynamics/run/error_tracker.hpp"

namespace rigid_body_sim {
namespace {

/// Steps and evaluations of a body for all trials of a scene: tenths of a second.
constexpr double kMostWork = 3e5;

/// Of the time up to the horizon: what is known of less is no reason to make every step dearer.
constexpr double kLeastShare = 0.1;

double largestGroup(const Run& run) {
  std::size_t largest = 1;
  for (const Group& group : run.now().groups.all())
    largest = std::max(largest, group.members().size());
  return static_cast<double>(largest);
}

/// Follows a run up to the horizon, beside the one that estimates its error, until the tolerance is
/// exceeded or the work is done.
ContactTrial follow(Run run, double bound, double& work) {
  const double horizon = run.now().world->solver.horizon;
  const auto bodies = static_cast<double>(run.now().groups.size());
  ErrorTracker error(run);
  try {
    while (run.now().time < horizon && work < kMostWork && std::isinf(error.estimate().lost_at)) {
      const std::int64_t evaluations = run.now().groups.evaluations();
      run.step();
      error.follow(run);
      const auto evaluated = static_cast<double>(run.now().groups.evaluations() - evaluations);
      work += bodies + evaluated * largestGroup(run);
    }
  } catch (const SimulationDiverged&) {
    // so will the run itself, and say so
  }
  return {bound, error.estimate().lost_at, run.now().time};
}

}  // namespace

bool needsContactTrial(const Run& run) {
  const SolverOptions& solver = run.now().world->solver;
  return solver.integrator == "auto" && solver.tolerance_stated &&
         !run.now().laws.contacts().empty() && run.now().start->contact_bound == 0 &&
         run.now().time < solver.horizon && run.contactTrial().step_bound > kLeastContactBound;
}

/// Of trials whose work ends too early to tell anything, what the one before has shown stays.
ContactTrial tryContact(const Run& run) {
  const double start = run.now().time, horizon = run.now().world->solver.horizon;
  ContactTrial found = run.contactTrial();
  double bound = found.step_bound;
  for (double work = 0; work < kMostWork;) {
    Run tried = run;
    tried.boundContact({bound});
    const ContactTrial trial = follow(std::move(tried), bound, work);
    const bool tells_little = trial.tried_until - start < kLeastShare * (horizon - start);
    const bool is_first = std::isinf(found.lost_at);
    if (std::isinf(trial.lost_at) && tells_little) {
      if (is_first) found.tried_until = trial.tried_until;
      break;
    }
    found = trial;
    if (std::isinf(trial.lost_at) || bound <= kLeastContactBound) break;
    bound = std::max(bound / kCompanionShare, kLeastContactBound);
  }
  return found;
}

}  // namespace rigid_body_sim
