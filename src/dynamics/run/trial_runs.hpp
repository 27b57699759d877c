#pragma once

#include <optional>
#include <vector>

#include "dynamics/run/group.hpp"
#include "dynamics/run/method_trial.hpp"

namespace rigid_body_sim {

/// Bodies at some instants of a run; none at instants that its steps do not meet.
using Track = std::vector<std::vector<BodyState>>;

struct TrialRun {
  Track track;
  int substeps;              ///< in which steps were taken: as many as asked for, or as it took
  double cost;               ///< of a step, counted in what was evaluated; Method::cost is its unit
  double even_cost;          ///< of that, what the substeps asked for cost: not those beside kinks
  std::int64_t rough_steps;  ///< see Workspace
};

/// Runs of bodies that act on one another by any integrator, from the same start. What it is made
/// of must outlive it.
class TrialRuns {
 public:
  TrialRuns(const World& world, const LawTable& laws, const CoupledBodies& group,
            const TrialStart& start, double max_body_steps);

  unsigned needs() const { return needs_; }
  int maxSubsteps() const { return max_substeps_; }
  double endTime() const { return time(steps_); }
  bool isCutShort() const { return steps_ < wantedSteps(); }

  /// Whether shorter steps gain nothing more: the errors, as shares of the tolerance, are those of
  /// steps short enough to be of the method's order, and fall no longer.
  bool isStuck(double error, double last_error) const;

  /// Nothing where the method cannot follow.
  std::optional<TrialRun> run(const Method& method, int substeps) const {
    return runBySteps(method, substeps, 1);
  }

  /// The worst error of attitude [rad], and of position relative to the path flown, as a share of
  /// the tolerance.
  double error(const Track& track, const Track& truth) const;

  /// The same of a run, as the simulation will estimate it by a run at twice the step (see
  /// ErrorTracker).
  double estimatedError(const Method& method, int substeps, const TrialRun& run) const;

 private:
  /// After so many steps; of a track.
  struct Instant {
    int step;
    bool is_early;  ///< else one of those at equal distances
  };

  double wantedSteps() const;
  void chooseInstants();
  double timeStep() const { return world_.solver.time_step; }
  double time(int step) const { return start_.t + step * timeStep(); }
  double substepsNeeded() const;
  double linkedFrom() const;
  Group groupUnder(const MethodChoice& choice) const;
  std::vector<BodyState> membersOf(const std::vector<BodyState>& bodies) const;
  std::optional<TrialRun> runBySteps(const Method& method, int substeps, int stride) const;

  const World& world_;
  const LawTable& laws_;
  const CoupledBodies& group_;
  unsigned needs_;
  const TrialStart& start_;
  std::vector<BodyState> start_states_;
  std::vector<double> rounding_;  // [m] body by body of the world
  int steps_ = 1;
  std::vector<Instant> instants_;
  int max_substeps_ = 1;
  double tolerance_ = 0;
};

}  // namespace rigid_body_sim
