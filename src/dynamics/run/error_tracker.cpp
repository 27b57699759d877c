#include "dynamics/run/error_tracker.hpp"

#include <algorithm>
#include <cmath>

namespace rigid_body_sim {
namespace {

/// Of contacts, errors remain in the flights that follow.
bool solvedToRounding(const Run& run, const Group& group) {
  return !group.choice().method && !run.world().solver.tolerance_stated && !run.hasContacts();
}

/// By how much the difference of the two runs exceeds the error of the finer one. In contact, both
/// follow their own error estimates, and differences grow from impact to impact: theirs is the
/// estimate.
double excessOf(const Run& run, const Group& group) {
  const Method* method = group.choice().method;
  return method && !run.hasContacts() ? std::exp2(method->order) - 1 : 1;
}

}  // namespace

ErrorTracker::ErrorTracker(const Run& run) {
  if (run.steps() % 2 == 0) start(run);
}

void ErrorTracker::start(const Run& run) {
  const std::vector<Group>& groups = run.groups().all();
  if (!std::all_of(groups.begin(), groups.end(),
                   [&](const Group& group) { return solvedToRounding(run, group); }))
    coarse_ = run.atTwiceTheStep();
}

void ErrorTracker::put(const std::string& slot, const PointWrench& wrench) {
  if (coarse_) coarse_->put(slot, wrench);
}

void ErrorTracker::command(const ActuatorCommand& command) {
  if (coarse_) coarse_->command(command);
}

void ErrorTracker::follow(const Run& run) {
  if (run.steps() % 2 != 0 || std::isinf(estimate_.attitude)) return;
  if (!coarse_) return start(run);
  try {
    while (2 * coarse_->steps() < run.steps()) coarse_->step();
  } catch (const SimulationDiverged&) {
    estimate_.attitude = estimate_.position = std::numeric_limits<double>::infinity();
    return;
  }
  for (const Group& group : run.groups().all()) {
    if (solvedToRounding(run, group)) continue;
    // a solved motion is compared with itself solved to rounding
    const double ratio = excessOf(run, group);
    for (std::size_t body : group.members()) {
      const BodyState fine = run.body(body), coarse = coarse_->body(body);
      estimate_.attitude =
          std::max(estimate_.attitude, angleBetween(fine.q_WP, coarse.q_WP) / ratio);
      estimate_.position = std::max(estimate_.position, distanceBetween(fine, coarse) / ratio);
    }
  }
}

}  // namespace rigid_body_sim
