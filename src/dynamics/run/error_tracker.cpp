#include "dynamics/run/error_tracker.hpp"

#include <algorithm>
#include <cmath>

namespace rigid_body_sim {
namespace {

/// Of contacts, errors remain in the flights that follow.
bool solvedToRounding(const Run& run, const Group& group) {
  return !group.choice().method && !run.now().world->solver.tolerance_stated &&
         run.now().laws.contacts().empty();
}

/// By how much the difference of the two runs exceeds the error of the finer one. In contact, both
/// follow their own error estimates, and differences grow from impact to impact: theirs is the
/// estimate. A body that is solved between two pulls of a tether keeps the errors of the integrator
/// that followed the first.
double excessOf(const Run& run, const Group& group) {
  const LawTable& laws = run.now().laws;
  const Method* method = group.choice().method;
  if (!laws.contacts().empty() || (!method && laws.oneSided().empty())) return 1;
  return std::exp2((method ? method : errorControlled().method)->order) - 1;
}

}  // namespace

bool isBeyond(double tolerance, double attitude, double position, const Body& body,
              const Path& path) {
  const bool has_moved = path.length > radiusOfGyration(body);
  return attitude > tolerance || (has_moved && position > tolerance * path.length);
}

ErrorTracker::ErrorTracker(const Run& run) {
  if (run.now().steps % 2 == 0) start(run);
}

void ErrorTracker::start(const Run& run) {
  const std::vector<Group>& groups = run.now().groups.all();
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
  if (run.now().steps % 2 != 0 || std::isinf(estimate_.attitude)) return;
  if (!coarse_) return start(run);
  try {
    while (2 * coarse_->now().steps < run.now().steps) coarse_->step();
  } catch (const SimulationDiverged&) {
    estimate_.attitude = estimate_.position = std::numeric_limits<double>::infinity();
    estimate_.lost_at = std::min(estimate_.lost_at, run.now().time);
    return;
  }
  for (std::size_t body = paths_.size(); body < run.now().world->bodies.size(); ++body)
    paths_.push_back({run.body(body)});
  for (const Group& group : run.now().groups.all())
    if (!solvedToRounding(run, group)) compare(run, group);
}

void ErrorTracker::compare(const Run& run, const Group& group) {
  const SolverOptions& solver = run.now().world->solver;
  // a solved motion is compared with itself solved to rounding
  const double ratio = excessOf(run, group);
  for (std::size_t body : group.members()) {
    const BodyState fine = run.body(body), coarse = coarse_->body(body);
    const double attitude = angleBetween(fine.q_WP, coarse.q_WP) / ratio;
    const double position = distanceBetween(fine, coarse) / ratio;
    paths_[body].goOn(fine);
    const bool exceeds =
        isBeyond(solver.tolerance, attitude, position, run.now().world->bodies[body], paths_[body]);
    if (exceeds && solver.integrator == "auto" &&
        run.now().time - run.now().horizon_begins <= solver.horizon)
      estimate_.lost_at = std::min(estimate_.lost_at, run.now().time);
    estimate_.attitude = std::max(estimate_.attitude, attitude);
    estimate_.position = std::max(estimate_.position, position);
  }
}

}  // namespace rigid_body_sim
