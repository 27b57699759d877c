#include "dynamics/run/contact_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "dynamics/run/contact_bound.hpp"
#include "dynamics/run/error_tracker.hpp"

namespace rigid_body_sim {
namespace {

/// Steps and evaluations of a body for all trials of a scene: tenths of a second.
constexpr double kMaxTrialWork = 5e5;

/// Of the time up to the horizon: what is known of less is no reason to make every step cost more.
constexpr double kLeastShare = 0.1;

/// Up to the horizon, at least, at which two runs of contact alone are compared, however long the
/// steps: those in contact are no longer for it. Of other forces parts of a step err by less than
/// the step.
constexpr double kFewestInstants = 32;

/// A run and others beside it, which tell its error. In contact that is one at looser bounds, so
/// that as much is asked for as of the estimate while it runs. Where other forces are integrated it
/// is one at tighter bounds: of two runs at looser ones, neither divides a step that errs by less
/// than its bound, and they agree.
class ComparedRun {
 public:
  explicit ComparedRun(Run run) : run_(std::move(run)) {
    constexpr double kMargin = 0.25;  // where rounding decides, both err by about as much
    const double tolerance = world().solver.tolerance;
    const std::size_t contacts = run_.now().laws.contacts().size();
    if (contacts > 0) others_.push_back({run_.atLooserBounds(), tolerance});
    if (world().laws.size() > contacts)
      others_.push_back({run_.atTighterBounds(), kMargin * tolerance});
    for (std::size_t body = 0; body < world().bodies.size(); ++body)
      paths_.push_back({run_.body(body)});
    for (const Group& group : run_.now().groups.all())
      if (group.choice().method && !group.choice().by_estimates)
        tried_.push_back({group.members(), group.choice().tried_until});
  }

  double time() const { return run_.now().time; }
  const World& world() const { return *run_.now().world; }

  /// To the end of the step, or to a time within it. Throws SimulationDiverged.
  void step(std::optional<double> t) {
    step(run_, t);
    for (Companion& other : others_) step(other.run, t);
  }

  /// Whether bodies are no longer advanced as was found for them at the start, before the end of
  /// what was tried then.
  bool hasRegrouped() const {
    return std::any_of(tried_.begin(), tried_.end(), [this](const TriedGroup& group) {
      const Group& now = run_.now().groups.of(group.members.front());
      return time() < group.until &&
             (now.members() != group.members || !now.choice().method || now.choice().by_estimates);
    });
  }

  /// Steps, and evaluations of a body, so far.
  double work() const { return work_; }

  /// Whether any two are apart by more than is allowed, now.
  bool haveParted() {
    bool parted = false;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (!moves(world().bodies[i])) continue;
      const BodyState state = run_.body(i);
      paths_[i].goOn(state);
      for (const Companion& companion : others_) {
        const BodyState other = companion.run.body(i);
        parted |= isBeyond(companion.allowed, angleBetween(state.q_WP, other.q_WP),
                           distanceBetween(state, other), world().bodies[i], paths_[i]);
      }
    }
    return parted;
  }

 private:
  void step(Run& run, std::optional<double> t) {
    const double before = run.now().groups.work();
    if (t)
      run.stepPart(*t);
    else
      run.step();
    const Groups& groups = run.now().groups;
    work_ += static_cast<double>(groups.size()) + groups.work() - before;
  }

  /// What is advanced as a trial of its own has found.
  struct TriedGroup {
    std::vector<std::size_t> members;
    double until;  // [s]
  };

  struct Companion {
    Run run;
    double allowed;  // how far apart they may come, as a tolerance
  };

  Run run_;
  std::vector<Companion> others_;
  std::vector<Path> paths_;  // by body
  std::vector<TriedGroup> tried_;
  double work_ = 0;
};

/// Follows a run up to the horizon, until the tolerance is exceeded, the work is done or bodies are
/// regrouped that should go by estimates then.
ContactTrial follow(Run run, double& work) {
  const SolverOptions solver = run.now().world->solver;
  const double h = solver.time_step;
  const bool is_contact_alone = run.now().laws.contacts().size() == run.now().world->laws.size();
  const double parts =
      is_contact_alone ? std::max(1.0, std::ceil(kFewestInstants * h / solver.horizon)) : 1;
  ContactTrial trial = run.contactTrial();
  trial.is_made = true;
  ComparedRun compared(std::move(run));
  double begin = compared.time();
  try {
    for (double part = 1;
         compared.time() < solver.horizon && work + compared.work() < kMaxTrialWork; ++part) {
      if (part < parts) {
        compared.step(begin + h * part / parts);
      } else {
        compared.step(std::nullopt);
        begin = compared.time();
        part = 0;
      }
      trial.tried_until = compared.time();
      trial.compares = true;
      if (compared.haveParted()) trial.lost_at = compared.time();
      const bool leaves_trials = !trial.regroups && compared.hasRegrouped();
      trial.regroups |= leaves_trials;
      if (std::isfinite(trial.lost_at) || leaves_trials) break;
    }
    work += compared.work();
  } catch (const SimulationDiverged&) {
    // so will the run itself, and say so; or a step takes more work than there is
    work = kMaxTrialWork;
  }
  return trial;
}

}  // namespace

bool needsContactTrial(const Run& run) {
  const SolverOptions& solver = run.now().world->solver;
  return solver.integrator == "auto" && solver.tolerance_stated &&
         !run.now().laws.oneSided().empty() && run.now().start->contact_bound == 0 &&
         run.now().time < solver.horizon;
}

/// Of trials whose work ends too early to tell anything, what the one before has shown stays.
ContactTrial tryContact(const Run& run) {
  const double start = run.now().time, horizon = run.now().world->solver.horizon;
  ContactTrial found = run.contactTrial();
  ContactTrial next = found;
  for (double work = 0; work < kMaxTrialWork;) {
    Run tried = run;
    tried.limitContactWork(kMaxTrialWork - work);
    tried.boundContact(next);
    const ContactTrial trial = follow(std::move(tried), work);
    if (trial.regroups && !next.regroups) {
      found = trial;
      next.regroups = true;
      continue;
    }
    const bool tells_little = trial.tried_until - start < kLeastShare * (horizon - start);
    const bool is_first = std::isinf(found.lost_at);
    if (std::isinf(trial.lost_at) && tells_little && !is_first) break;
    found = trial;
    if (std::isinf(trial.lost_at) || next.step_bound <= kLeastContactBound) break;
    next.step_bound = std::max(next.step_bound / kCompanionShare, kLeastContactBound);
  }
  return found;
}

}  // namespace rigid_body_sim
