#include "dynamics/run/choose_method.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "dynamics/run/group.hpp"

namespace rigid_body_sim {
namespace {

/// Bodies at some instants of a run.
using Track = std::vector<std::vector<BodyState>>;

struct Run {
  Track track;
  int parts;    ///< in which steps were taken: as many as asked for, or as it took
  double cost;  ///< of a step, counted in what was evaluated; Method::cost is its unit
};

/// A trial of every row from the same start.
class Trial {
  static constexpr double kParts = 8;  // into which every step can at least be divided

 public:
  Trial(const World& world, const CoupledBodies& group, const State& state,
        const std::vector<WrenchSchedule>& schedules, double most_body_steps)
      : world_(world),
        group_(group),
        needs_(needsOf(world, group, schedules)),
        start_(state),
        schedules_(schedules) {
    const double wanted = wantedSteps();
    const double affordable = most_body_steps / static_cast<double>(group.members.size());
    const double parts = std::max(kParts, partsNeeded());
    steps_ = static_cast<int>(std::min(wanted, std::max(8.0, affordable / parts)));
    most_parts_ = static_cast<int>(std::max(parts, affordable / steps_));
    const double share = steps_ / wanted;
    tolerance_ = world.solver.tolerance * std::min(1.0, share * share);
  }

  int mostParts() const { return most_parts_; }
  double endTime() const { return time(steps_); }
  bool isCutShort() const { return steps_ < wantedSteps(); }

  /// Whether shorter steps gain nothing more: the errors, as shares of the tolerance, are those of
  /// steps short enough to be of the method's order, and fall no longer.
  bool isStuck(double error, double last_error) const {
    constexpr double kSmall = 1e-8;  // [rad]
    return error < std::max(1e3, kSmall / tolerance_) && error > last_error / 1.5;
  }

  /// Nothing where the method cannot follow.
  std::optional<Run> run(const Method& method, int parts) const {
    constexpr int kInstants = 16;
    Group group(world_, group_, needs_, {&method, parts});
    std::vector<WrenchSchedule> schedules = schedules_;
    std::vector<BodyState> bodies = start_.bodies;
    group.restart(start_.t, schedules);
    Run run;
    try {
      for (int i = 0; i < steps_; ++i) {
        group.advance(time(i), time(i + 1), schedules, bodies);
        group.putStates(bodies);
        if ((i + 1) * kInstants / steps_ > i * kInstants / steps_)
          run.track.push_back(membersOf(bodies));
      }
    } catch (const StepTooLong&) {
      return std::nullopt;
    }
    run.parts = std::max(parts, group.mostParts());
    run.cost =
        method.cost * static_cast<double>(group.evaluations()) / (method.evaluations * steps_);
    return run;
  }

  /// The worst error of attitude [rad], and of position relative to the path flown, as a share of
  /// the tolerance.
  double error(const Track& track, const Track& truth) const {
    double worst = 0;
    for (std::size_t k = 0; k < group_.members.size(); ++k) {
      double path = 0;
      Vector3d last = start_.bodies[group_.members[k]].x_W;
      for (std::size_t i = 0; i < truth.size(); ++i) {
        path += (truth[i][k].x_W - last).norm();
        last = truth[i][k].x_W;
        const double apart = (track[i][k].x_W - truth[i][k].x_W).norm();
        const double gap =
            std::max(0.0, apart - positionRounding(world_.bodies[group_.members[k]], truth[i][k]));
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

  /// Parts of a step that dop853 cannot do without at the start.
  double partsNeeded() const {
    Group group(world_, group_, needs_, {&methodNamed("dop853")});
    std::vector<WrenchSchedule> schedules = schedules_;
    group.restart(start_.t, schedules);
    return std::min(1e5, group.partsNeeded(world_.solver.time_step, start_.bodies));
  }

  double time(int step) const { return start_.t + step * world_.solver.time_step; }

  std::vector<BodyState> membersOf(const std::vector<BodyState>& bodies) const {
    std::vector<BodyState> states;
    for (std::size_t body : group_.members) states.push_back(bodies[body]);
    return states;
  }

  const World& world_;
  const CoupledBodies& group_;
  unsigned needs_;
  const State& start_;
  const std::vector<WrenchSchedule>& schedules_;
  int steps_ = 1;
  int most_parts_ = 1;
  double tolerance_ = 0;
};

/// What the rows are held against.
struct Truth {
  Track track;
  int parts;    ///< of its steps
  bool agrees;  ///< with itself at longer steps, within the tolerance or as far as rounding lets it
};

/// dop853 in more and more parts until it agrees with itself to a hundredth of the tolerance, or no
/// better: the last is the truth that the rows are held against.
std::optional<Truth> truthOf(const Trial& trial) {
  const Method& dop853 = methodNamed("dop853");
  std::optional<Track> last;
  int last_parts = 1;
  double last_cost = 0;
  double last_error = std::numeric_limits<double>::infinity();
  for (int parts = 1; parts <= trial.mostParts(); parts *= 2) {
    std::optional<Run> run = trial.run(dop853, parts);
    if (run) parts = run->parts;
    // a step that divides itself would only agree with itself
    const bool shorter = run && run->cost > 1.9 * last_cost;
    if (shorter && last) {
      const double error = trial.error(*last, run->track);
      if (error < 0.01 || (error < 1 && error >= last_error) || trial.isStuck(error, last_error))
        return Truth{std::move(run->track), parts, true};
      last_error = error;
    }
    last.reset();
    if (run) last_cost = run->cost;
    if (run) last = std::move(run->track);
    last_parts = parts;
  }
  if (!last) return std::nullopt;
  return Truth{std::move(*last), last_parts, last_error < 1};
}

}  // namespace

MethodChoice controlledChoice() {
  MethodChoice choice{&methodNamed("dop853")};
  choice.controlled = true;
  return choice;
}

MethodChoice chooseMethod(const World& world, const CoupledBodies& group, const State& state,
                          const std::vector<WrenchSchedule>& schedules, double most_body_steps) {
  constexpr double kMargin = 0.5;  // of the tolerance: the truth is itself a computed motion
  const unsigned needs = needsOf(world, group, schedules);
  const Trial trial(world, group, state, schedules, most_body_steps);
  const std::optional<Truth> truth = truthOf(trial);
  MethodChoice best = controlledChoice();
  best.error = std::numeric_limits<double>::infinity();
  best.holds = false;
  if (!truth || !truth->agrees) return best;
  double best_cost = std::numeric_limits<double>::infinity();
  // from the highest order down: what holds a tight tolerance bounds the cost of the others early
  for (auto row = catalogue().rbegin(); row != catalogue().rend(); ++row) {
    if (!row->takes(needs)) continue;
    double last_error = std::numeric_limits<double>::infinity();
    for (int parts = 1; parts * row->cost < best_cost && parts <= trial.mostParts(); parts *= 2) {
      const std::optional<Run> run = trial.run(*row, parts);
      if (run) parts = run->parts;
      const double error = run ? trial.error(run->track, truth->track) : last_error;
      const bool holds = run && error <= kMargin;
      if (holds && run->cost >= best_cost) break;
      if (holds) best_cost = run->cost;
      if (holds) best = {&*row, parts, error, 1, true, trial.endTime(), trial.isCutShort()};
      best.error = std::min(error, best.error);
      // rounding has the better of the shorter step, or the row cannot get there
      if (holds || trial.isStuck(error, last_error)) break;
      last_error = error;
    }
  }
  return best;
}

}  // namespace rigid_body_sim
