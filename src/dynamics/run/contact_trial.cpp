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

/// Of the time up to the horizon: what is known of less is no reason to make every step dearer.
constexpr double kLeastShare = 0.1;

/// Up to the horizon, at least, at which two runs are compared, however long the steps.
constexpr double kFewestInstants = 32;

/// A run and one beside it at looser bounds, which tells its error.
class TrialPair {
 public:
  explicit TrialPair(Run run) : run_(std::move(run)), loose_(run_.atLooserBounds()) {
    for (std::size_t body = 0; body < world().bodies.size(); ++body)
      paths_.push_back({run_.body(body)});
  }

  double time() const { return run_.now().time; }
  const World& world() const { return *run_.now().world; }

  /// To the end of the step, or to a time within it. Throws SimulationDiverged.
  void step(std::optional<double> t) {
    for (Run* run : {&run_, &loose_}) {
      const double before = run->now().groups.work();
      if (t)
        run->stepPart(*t);
      else
        run->step();
      const Groups& groups = run->now().groups;
      work_ += static_cast<double>(groups.size()) + groups.work() - before;
    }
  }

  /// Steps, and evaluations of a body, so far.
  double work() const { return work_; }

  /// Whether the two are apart by more than the tolerance, now.
  bool haveParted() {
    bool parted = false;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (!moves(world().bodies[i])) continue;
      const BodyState fine = run_.body(i), coarse = loose_.body(i);
      paths_[i].goOn(fine);
      parted |= isBeyond(world().solver.tolerance, angleBetween(fine.q_WP, coarse.q_WP),
                         distanceBetween(fine, coarse), world().bodies[i], paths_[i]);
    }
    return parted;
  }

 private:
  Run run_, loose_;
  std::vector<Path> paths_;  // by body
  double work_ = 0;
};

/// Follows a run up to the horizon, until the tolerance is exceeded or the work is done.
ContactTrial follow(Run run, double bound, double& work) {
  const SolverOptions solver = run.now().world->solver;
  const double h = solver.time_step;
  const double parts = std::max(1.0, std::ceil(kFewestInstants * h / solver.horizon));
  TrialPair pair(std::move(run));
  ContactTrial trial{bound, std::numeric_limits<double>::infinity(), pair.time(), true};
  double begin = pair.time();
  try {
    for (double part = 1; pair.time() < solver.horizon && work + pair.work() < kMaxTrialWork;
         ++part) {
      if (part < parts) {
        pair.step(begin + h * part / parts);
      } else {
        pair.step(std::nullopt);
        begin = pair.time();
        part = 0;
      }
      trial.tried_until = pair.time();
      trial.compares = true;
      if (!pair.haveParted()) continue;
      trial.lost_at = pair.time();
      break;
    }
    work += pair.work();
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
         !run.now().laws.contacts().empty() && run.now().start->contact_bound == 0 &&
         run.now().time < solver.horizon;
}

/// Of trials whose work ends too early to tell anything, what the one before has shown stays.
ContactTrial tryContact(const Run& run) {
  const double start = run.now().time, horizon = run.now().world->solver.horizon;
  ContactTrial found = run.contactTrial();
  double bound = found.step_bound;
  for (double work = 0; work < kMaxTrialWork;) {
    Run tried = run;
    tried.limitContactWork(kMaxTrialWork - work);
    tried.boundContact({bound});
    const ContactTrial trial = follow(std::move(tried), bound, work);
    const bool tells_little = trial.tried_until - start < kLeastShare * (horizon - start);
    const bool is_first = std::isinf(found.lost_at);
    if (std::isinf(trial.lost_at) && tells_little && !is_first) break;
    found = trial;
    if (std::isinf(trial.lost_at) || bound <= kLeastContactBound) break;
    bound = std::max(bound / kCompanionShare, kLeastContactBound);
  }
  return found;
}

}  // namespace rigid_body_sim
