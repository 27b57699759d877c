#pragma once

#include <limits>
#include <vector>

#include "dynamics/run/law_watches.hpp"
#include "dynamics/run/method_planner.hpp"

namespace rigid_body_sim {

/// Decides which bodies of a run are advanced together, and how: where wrenches that turn with
/// another body start and end, and where laws begin and cease to act, groups form and part.
class Grouping {
 public:
  /// Throws std::invalid_argument for an integrator that is unknown.
  explicit Grouping(const RunState& run) : planner_(*run.world), watches_(*run.world, run.laws) {}

  MethodPlanner& planner() { return planner_; }
  const MethodPlanner& planner() const { return planner_; }
  LawWatches& watches() { return watches_; }
  const LawWatches& watches() const { return watches_; }

  /// Whether groups may form or part up to t [s].
  bool mayChangeBy(double t) const { return next_link_ <= t || watches_.quietUntil() <= t; }

  /// [s] When wrenches link or part bodies next; to be found anew where schedules change.
  double nextLink() const { return next_link_; }
  void findNextLink(const RunState& run);

  /// The bodies that wrenches link or part by time t [s], and those at the other end.
  static std::vector<std::size_t> linkedBy(double t, const RunState& run);

  /// Lets everything know which laws may act up to t_end [s] that need bodies to be near each
  /// other; with findCandidatesNow, by the present alone, whatever was looked for before.
  void findCandidates(RunState& run, double t_end) { findCandidates(run, t_end, true); }
  void findCandidatesNow(RunState& run, double t_end) { findCandidates(run, t_end, false); }

  /// Forms the groups of a run that begins at a state, as the state has them if it does. scheduled:
  /// with the wrenches of the scene. Throws std::invalid_argument for groups that cannot be.
  void form(RunState& run, const State& start, bool scheduled);

  /// Forms the groups of these bodies anew at time t, the present of all of them: what is linked as
  /// before goes on as it is, unless it is to be made anew.
  void regroup(RunState& run, const std::vector<std::size_t>& bodies, double t, bool anew = false);

  /// To be called for a body that no longer moves as the scene predicted, nor do those with it.
  void disturb(RunState& run, std::size_t body);

  /// Forms the groups of a run that is compared with another like those of that one.
  void formBeside(RunState& run, const RunState& other, const Beside& beside);

 private:
  void findCandidates(RunState& run, double t_end, bool looks_ahead);
  void restore(RunState& run, const State& start);
  void formAnew(RunState& run, const State& start, bool scheduled);
  Group formedGroup(const RunState& run, const CoupledBodies& bodies, const State& start,
                    const MethodChoice& choice) const;

  MethodPlanner planner_;
  LawWatches watches_;
  double next_link_ = std::numeric_limits<double>::infinity();
};

}  // namespace rigid_body_sim
