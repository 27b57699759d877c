#include "dynamics/run/method_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "dynamics/run/group.hpp"
#include "dynamics/run/position_rounding.hpp"

namespace rigid_body_sim {
namespace {

/// Bodies at some instants of a run.
using Track = std::vector<std::vector<BodyState>>;

struct TrialRun {
  Track track;
  int substeps;              ///< in which steps were taken: as many as asked for, or as it took
  double cost;               ///< of a step, counted in what was evaluated; Method::cost is its unit
  std::int64_t rough_steps;  ///< see Workspace
};

/// A trial of every integrator from the same start.
class Trial {
  static constexpr double kSubsteps = 8;  // into which every step can at least be divided

 public:
  Trial(const World& world, const LawTable& laws, const CoupledBodies& group,
        const TrialStart& start, double max_body_steps)
      : world_(world),
        laws_(laws),
        group_(group),
        needs_(needsOf(world, group, start.schedules)),
        start_(start),
        start_states_(membersOf(start.bodies)),
        rounding_(positionRounding(world, start.bodies, start.laws)) {
    const double wanted = wantedSteps();
    const double affordable = max_body_steps / static_cast<double>(group.members.size());
    const double substeps = std::max(kSubsteps, substepsNeeded());
    const double possible = std::max(1.0, std::floor((linkedFrom() - start.t) / timeStep()));
    steps_ = static_cast<int>(std::min({wanted, possible, std::max(8.0, affordable / substeps)}));
    max_substeps_ = static_cast<int>(std::max(substeps, affordable / steps_));
    const double share = steps_ / wanted;
    tolerance_ = world.solver.tolerance * std::min(1.0, share * share);
  }

  unsigned needs() const { return needs_; }
  int maxSubsteps() const { return max_substeps_; }
  double endTime() const { return time(steps_); }
  bool isCutShort() const { return steps_ < wantedSteps(); }

  /// Whether shorter steps gain nothing more: the errors, as shares of the tolerance, are those of
  /// steps short enough to be of the method's order, and fall no longer.
  bool isStuck(double error, double last_error) const {
    constexpr double kSmall = 1e-8;  // [rad]
    return error < std::max(1e3, kSmall / tolerance_) && error > last_error / 1.5;
  }

  /// Nothing where the method cannot follow.
  std::optional<TrialRun> run(const Method& method, int substeps) const {
    constexpr int kInstants = 16;
    std::vector<WrenchSchedule> schedules = start_.schedules;
    Group group = groupUnder({&method, substeps});
    TrialRun run;
    try {
      for (int i = 0; i < steps_; ++i) {
        group.advance(time(i), time(i + 1), schedules);
        group.accept(time(i + 1));
        if ((i + 1) * kInstants / steps_ > i * kInstants / steps_)
          run.track.push_back(group.present().bodies);
      }
    } catch (const StepTooLong&) {
      return std::nullopt;
    }
    run.substeps = std::max(substeps, group.maxSubsteps());
    run.cost =
        method.cost * static_cast<double>(group.evaluations()) / (method.evaluations * steps_);
    run.rough_steps = group.roughSteps();
    return run;
  }

  /// The worst error of attitude [rad], and of position relative to the path flown, as a share of
  /// the tolerance.
  double error(const Track& track, const Track& truth) const {
    double worst = 0;
    for (std::size_t k = 0; k < group_.members.size(); ++k) {
      double path = 0;
      BodyState last = start_states_[k];
      for (std::size_t i = 0; i < truth.size(); ++i) {
        path += distanceBetween(truth[i][k], last);
        last = truth[i][k];
        const double apart = distanceBetween(track[i][k], truth[i][k]);
        const double gap = std::max(0.0, apart - rounding_[group_.members[k]]);
        const double attitude = angleBetween(track[i][k].q_WP, truth[i][k].q_WP);
        if (!std::isfinite(apart + attitude)) return std::numeric_limits<double>::infinity();
        worst = std::max({worst, attitude, path > 0 ? gap / path : gap});
      }
    }
    return worst / tolerance_;
  }

 private:
  double wantedSteps() const {
    return std::max(1.0, std::ceil(world_.solver.horizon / world_.solver.time_step));
  }

  Group groupUnder(const MethodChoice& choice) const {
    return Group(world_, laws_, group_, choice, start_.t, start_states_, start_.laws,
                 start_.schedules);
  }

  /// Substeps that dop853 cannot do without at the start.
  double substepsNeeded() const {
    const Group group = groupUnder({&methodNamed("dop853")});
    return std::min(1e5, group.substepsNeeded(timeStep()));
  }

  /// [s] When a wrench begins to link the group with bodies outside it.
  double linkedFrom() const {
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t body : group_.members)
      first = std::min(first, start_.schedules[body].nextLink(group_.members));
    return first;
  }

  double timeStep() const { return world_.solver.time_step; }
  double time(int step) const { return start_.t + step * timeStep(); }

  std::vector<BodyState> membersOf(const std::vector<BodyState>& bodies) const {
    std::vector<BodyState> states;
    for (std::size_t body : group_.members) states.push_back(bodies[body]);
    return states;
  }

  const World& world_;
  const LawTable& laws_;
  const CoupledBodies& group_;
  unsigned needs_;
  const TrialStart& start_;
  std::vector<BodyState> start_states_;
  std::vector<double> rounding_;  // [m] body by body of the world
  int steps_ = 1;
  int max_substeps_ = 1;
  double tolerance_ = 0;
};

/// What the integrators are compared with.
struct Truth {
  Track track;
  int substeps;  ///< of its steps
  bool agrees;  ///< with itself at longer steps, within the tolerance or as far as rounding lets it
};

/// dop853 in more and more substeps until it agrees with itself to a hundredth of the tolerance, or
/// no better.
std::optional<Truth> truthOf(const Trial& trial) {
  const Method& dop853 = methodNamed("dop853");
  std::optional<Track> last;
  int last_substeps = 1;
  double last_cost = 0;
  double last_error = std::numeric_limits<double>::infinity();
  std::int64_t last_rough_steps = std::numeric_limits<std::int64_t>::max();
  for (int substeps = 1; substeps <= trial.maxSubsteps(); substeps *= 2) {
    std::optional<TrialRun> run = trial.run(dop853, substeps);
    if (run) substeps = run->substeps;
    // a step that divides itself would only agree with itself
    const std::int64_t rough_steps = run ? run->rough_steps : 0;
    if (rough_steps >= last_rough_steps) return std::nullopt;  // forces jump
    if (rough_steps > 0) {
      last_rough_steps = rough_steps;
      run.reset();
    }
    const bool shorter = run && run->cost > 1.9 * last_cost;
    if (shorter && last) {
      const double error = trial.error(*last, run->track);
      if (error < 0.01 || (error < 1 && error >= last_error) || trial.isStuck(error, last_error))
        return Truth{std::move(run->track), substeps, true};
      last_error = error;
    }
    last.reset();
    if (run) {
      last_cost = run->cost;
      last = std::move(run->track);
    }
    last_substeps = substeps;
  }
  if (!last) return std::nullopt;
  return Truth{std::move(*last), last_substeps, last_error < 1};
}

}  // namespace

MethodChoice chooseMethod(const World& world, const LawTable& laws, const CoupledBodies& group,
                          const TrialStart& start, double max_body_steps) {
  constexpr double kMargin = 0.5;  // of the tolerance: the truth is itself a computed motion
  const Trial trial(world, laws, group, start, max_body_steps);
  const std::optional<Truth> truth = truthOf(trial);
  MethodChoice best = errorControlled();
  best.error = std::numeric_limits<double>::infinity();
  best.holds = false;
  if (!truth || !truth->agrees) return best;
  double best_cost = std::numeric_limits<double>::infinity();
  // from the highest order down: what holds a tight tolerance bounds the cost of the others early
  for (auto method = catalogue().rbegin(); method != catalogue().rend(); ++method) {
    if (!method->supports(trial.needs())) continue;
    double last_error = std::numeric_limits<double>::infinity();
    for (int substeps = 1; substeps * method->cost < best_cost && substeps <= trial.maxSubsteps();
         substeps *= 2) {
      const std::optional<TrialRun> run = trial.run(*method, substeps);
      if (run) substeps = run->substeps;
      const double error = run ? trial.error(run->track, truth->track) : last_error;
      const bool holds = run && error <= kMargin;
      if (holds && run->cost >= best_cost) break;
      if (holds) {
        best_cost = run->cost;
        best = {&*method, substeps, error, 1, true, trial.endTime(), trial.isCutShort(), false};
      }
      best.error = std::min(error, best.error);
      // shorter steps no longer help: rounding dominates, or the integrator cannot get there
      if (holds || trial.isStuck(error, last_error)) break;
      last_error = error;
    }
  }
  return best;
}

}  // namespace rigid_body_sim
