#include "dynamics/run/method_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "dynamics/run/trial_runs.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// What the integrators are compared with.
struct Truth {
  std::map<int, std::optional<TrialRun>> runs;  ///< of dop853, by the substeps asked for
  int substeps = 0;                             ///< of the run that is the truth; 0: none
  bool agrees = false;  ///< with itself at longer steps, within the tolerance or as far as rounding
                        ///< lets it
  double noise = 0;     ///< of rounding, that shorter steps do not take away, as a share of the
                        ///< tolerance; 0 where runs agree before it is seen

  static const Method& method() { return methodNamed("dop853"); }
  bool meetsKinks() const {
    const TrialRun& run = *runs.at(substeps);
    return run.even_cost < run.cost;
  }
  const Track& track() const { return runs.at(substeps)->track; }
};

/// dop853 in more and more substeps until it agrees with itself to a hundredth of the tolerance, or
/// no better.
Truth truthOf(const TrialRuns& trial) {
  Truth truth;
  double last_cost = 0;
  double last_error = kUnknown;
  std::int64_t last_rough_steps = std::numeric_limits<std::int64_t>::max();
  for (int substeps = 1; substeps <= trial.maxSubsteps();) {
    const std::optional<TrialRun>& run = truth.runs[substeps] =
        trial.run(Truth::method(), substeps);
    // a step that divides itself would only agree with itself
    const std::int64_t rough_steps = run ? run->rough_steps : 0;
    if (rough_steps >= last_rough_steps) return Truth();  // forces jump
    if (rough_steps > 0) last_rough_steps = rough_steps;
    const bool counts = run && rough_steps == 0;
    if (counts && truth.substeps && run->even_cost > 1.9 * last_cost) {
      const double error = trial.error(truth.track(), run->track);
      const bool is_noise = (error < 1 && error >= last_error) || trial.isStuck(error, last_error);
      if (error < 0.01 || is_noise) {
        truth.substeps = substeps;
        truth.agrees = true;
        if (error >= 0.01) truth.noise = error;
        return truth;
      }
      last_error = error;
    }
    if (counts) last_cost = run->even_cost;
    truth.substeps = counts ? substeps : 0;
    substeps = 2 * (run ? run->substeps : substeps);
  }
  truth.agrees = truth.substeps > 0 && last_error < 1;
  return truth;
}

/// As a share of the tolerance: half of it may be found against the truth, a fourth be noise of the
/// run, and a fourth that of the truth.
constexpr double kMargin = 0.5, kMaxNoise = 0.25;

/// A number of substeps that was tried.
struct Tried {
  int substeps = 0;
  double cost = kUnknown;
  double error = kUnknown;   ///< as a share of the tolerance
  double excess = kUnknown;  ///< of what was found over what is allowed; up to 1 it holds

  bool holds() const { return excess <= 1; }

  /// The substeps whose excess would be 1, if it falls by that order.
  double forExcessOfOne(double order) const { return substeps * std::pow(excess, 1 / order); }
};

/// The search for the cheapest integrator and number of substeps that hold the tolerance.
class Search {
 public:
  Search(const TrialRuns& trial, const Truth& truth) : trial_(trial), truth_(truth) {
    best_.error = kUnknown;
    best_.holds = false;
  }

  const MethodChoice& best() const { return best_; }

  /// Doubles the substeps of an integrator until they hold, as long as they may be cheaper than the
  /// best; then looks for fewer in between.
  void climb(const Method& method) {
    Tried last;
    int substeps = 1;
    while (substeps <= trial_.maxSubsteps() && isCheaper(method, substeps)) {
      const Tried tried = tryOnLadder(method, substeps, last.error);
      if (!best_.holds) best_.error = std::min(tried.error, best_.error);
      if (tried.holds()) {
        if (tried.cost < best_cost_) {
          take(method, tried);
          refine(method, last, tried);
        }
        return;
      }
      // shorter steps no longer help: rounding dominates, or the integrator cannot get there
      if (trial_.isStuck(tried.error, last.error)) return;
      last = tried;
      substeps = 2 * tried.substeps;
    }
    const double between = std::ceil(last.forExcessOfOne(method.order));
    if (between < std::min<double>(substeps, trial_.maxSubsteps()) && isCheaper(method, between))
      tryBetween(method, static_cast<int>(between));
  }

 private:
  static constexpr double kEstimate =
      1;  // of the tolerance, from where on the status says that it is lost

  bool isCheaper(const Method& method, double substeps) const {
    return substeps * method.cost < best_cost_;
  }

  /// Of what it is apart from the truth, so much may be noise of either.
  Tried judged(const TrialRun& run) const {
    const double error = trial_.error(run.track, truth_.track());
    return {run.substeps, run.cost, error, error / (kMargin + truth_.noise)};
  }

  /// error_else: taken for that of a method that cannot follow.
  Tried tryOnLadder(const Method& method, int substeps, double error_else) const {
    const auto judgedOr = [&](const std::optional<TrialRun>& run) {
      return run ? judged(*run) : Tried{substeps, kUnknown, error_else, kUnknown};
    };
    const auto known = truth_.runs.find(substeps);
    if (&method == &Truth::method() && known != truth_.runs.end()) return judgedOr(known->second);
    return judgedOr(trial_.run(method, substeps));
  }

  /// Takes it where it holds and is the cheapest. In so many substeps the error comes close to what
  /// is allowed: what the simulation estimates of it must not be beyond the tolerance, either.
  Tried tryBetween(const Method& method, int substeps) {
    const std::optional<TrialRun> run = trial_.run(method, substeps);
    if (!run) return {substeps, kUnknown, kUnknown, kUnknown};
    Tried tried = judged(*run);
    if (!tried.holds() || tried.cost >= best_cost_) return tried;
    tried.excess =
        std::max(tried.excess, trial_.estimatedError(method, substeps, *run) / kEstimate);
    if (tried.holds()) take(method, tried);
    return tried;
  }

  /// Fewer substeps, between those that do not hold and those that do, where that pays.
  void refine(const Method& method, Tried low, Tried high) {
    constexpr int kTrials = 2;
    constexpr double kWorthIt = 0.9;  // of the substeps
    if (low.substeps == 0) return;    // no fewer are possible
    for (int k = 0; k < kTrials && high.error > 0; ++k) {
      const double measured =
          std::log(low.excess / high.excess) / std::log(double(high.substeps) / low.substeps);
      const double order =
          std::isfinite(measured) ? std::max<double>(method.order, measured) : method.order;
      const double least = std::max(low.substeps + 1.0, std::ceil(high.forExcessOfOne(order)));
      if (least > kWorthIt * high.substeps) return;
      const Tried tried = tryBetween(method, static_cast<int>(least));
      (tried.holds() ? high : low) = tried;
    }
  }

  void take(const Method& method, const Tried& tried) {
    best_cost_ = tried.cost;
    best_ = {&method, tried.substeps,   tried.error,         1,
             true,    trial_.endTime(), trial_.isCutShort(), false};
  }

  const TrialRuns& trial_;
  const Truth& truth_;
  MethodChoice best_ = errorControlled();
  double best_cost_ = kUnknown;
};

/// The motion magnifies rounding so much that no steps hold the tolerance for certain.
MethodChoice lostInRounding(double noise) {
  MethodChoice choice = errorControlled();
  choice.holds = false;
  choice.error = noise;
  return choice;
}

}  // namespace

MethodChoice chooseMethod(const World& world, const LawTable& laws, const CoupledBodies& group,
                          const TrialStart& start, double max_body_steps) {
  const TrialRuns trial(world, laws, group, start, max_body_steps);
  const Truth truth = truthOf(trial);
  if (truth.noise > kMaxNoise) return lostInRounding(truth.noise);
  Search search(trial, truth);
  if (truth.agrees && truth.meetsKinks())
    // what others err by there depends on where in a substep a kink falls: at the ends of steps it
    // may be small by accident
    search.climb(Truth::method());
  else if (truth.agrees)
    // from the highest order down: what holds a tight tolerance bounds the cost of the others early
    for (auto method = catalogue().rbegin(); method != catalogue().rend(); ++method)
      if (method->supports(trial.needs())) search.climb(*method);
  return search.best();
}

}  // namespace rigid_body_sim
