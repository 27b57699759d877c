#include "dynamics/run/trial_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "dynamics/run/group.hpp"
#include "dynamics/run/position_rounding.hpp"

namespace rigid_body_sim {
namespace {

/// Evaluations of a step that ends at events: three times the hundred by which dop853 takes a
/// substep and looks for them, and hundreds of events. A motion that meets ever more of them, such
/// as one that spirals into the centre of a force, is not tried to its end, which may take minutes.
double eventWork(int substeps) {
  constexpr double kLeast = 3e5, kOfSubstep = 300;
  return kLeast + kOfSubstep * substeps;
}

}  // namespace

TrialRuns::TrialRuns(const World& world, const LawTable& laws, const CoupledBodies& group,
                     const TrialStart& start, double max_body_steps)
    : world_(world),
      laws_(laws),
      group_(group),
      needs_(needsOf(world, group, start.schedules)),
      start_(start),
      start_states_(membersOf(start.bodies)),
      rounding_(positionRounding(world, start.bodies, start.laws)) {
  constexpr double kSubsteps = 8;  // into which every step can at least be divided
  const double wanted = wantedSteps();
  const double affordable = max_body_steps / static_cast<double>(group.members.size());
  const double substeps = std::max(kSubsteps, substepsNeeded());
  const double possible = std::max(1.0, std::floor((linkedFrom() - start.t) / timeStep()));
  steps_ = static_cast<int>(std::min({wanted, possible, std::max(8.0, affordable / substeps)}));
  max_substeps_ = static_cast<int>(std::max(substeps, affordable / steps_));
  const double share = steps_ / wanted;
  tolerance_ = world.solver.tolerance * std::min(1.0, share * share);
  chooseInstants();
}

/// At equal distances, since errors grow, and ever closer towards the start, since motions die out,
/// and with them what was wrong on the way: after even numbers of steps, which a run at twice the
/// step meets.
void TrialRuns::chooseInstants() {
  constexpr int kEqual = 16;
  constexpr double kFurther = 1.1;
  std::map<int, bool> instants;
  for (double step = 2; step < steps_;
       step = std::max(step + 2, 2 * std::floor(kFurther * step / 2)))
    instants[static_cast<int>(step)] = true;
  for (std::int64_t k = 1; k <= kEqual; ++k)
    instants[static_cast<int>((k * steps_ + kEqual - 1) / kEqual)] = false;
  for (const auto& [step, is_early] : instants) instants_.push_back({step, is_early});
}

bool TrialRuns::isStuck(double error, double last_error) const {
  constexpr double kSmall = 1e-8;  // [rad]
  return error < std::max(1e3, kSmall / tolerance_) && error > last_error / 1.5;
}

/// stride: how many of the world's steps are taken as one.
std::optional<TrialRun> TrialRuns::runBySteps(const Method& method, int substeps,
                                              int stride) const {
  MethodChoice choice{&method, substeps};
  choice.max_turn_share = stride;
  choice.event_work = eventWork(substeps);
  std::vector<WrenchSchedule> schedules = start_.schedules;
  Group group = groupUnder(choice);
  TrialRun run;
  try {
    for (int i = 0; i < steps_; ++i) {
      const bool ends = (i + 1) % stride == 0;
      if (ends) {
        group.advance(time(i + 1 - stride), time(i + 1), schedules);
        group.accept(time(i + 1));
      }
      if (i + 1 == instants_[run.track.size()].step)
        run.track.push_back(ends ? group.present().bodies : std::vector<BodyState>());
    }
  } catch (const StepTooLong&) {
    return std::nullopt;
  }
  run.substeps = std::max(substeps, group.maxSubsteps());
  run.cost = method.cost * static_cast<double>(group.evaluations()) / (method.evaluations * steps_);
  run.even_cost = run.cost - method.cost * static_cast<double>(group.kinkSubsteps()) / steps_;
  run.rough_steps = group.roughSteps();
  return run;
}

double TrialRuns::error(const Track& track, const Track& truth) const {
  double worst = 0;
  for (std::size_t k = 0; k < group_.members.size(); ++k) {
    double path = 0;
    BodyState last = start_states_[k];
    for (std::size_t i = 0; i < truth.size(); ++i) {
      path += distanceBetween(truth[i][k], last);
      last = truth[i][k];
      if (track[i].empty()) continue;
      const double apart = distanceBetween(track[i][k], truth[i][k]);
      const double gap = std::max(0.0, apart - rounding_[group_.members[k]]);
      const double attitude = angleBetween(track[i][k].q_WP, truth[i][k].q_WP);
      if (!std::isfinite(apart + attitude)) return std::numeric_limits<double>::infinity();
      // on the little way at first, any step errs by much
      const Body& body = world_.bodies[group_.members[k]];
      const double way = instants_[i].is_early ? std::max(path, radiusOfGyration(body)) : path;
      worst = std::max({worst, attitude, way > 0 ? gap / way : gap});
    }
  }
  return worst / tolerance_;
}

double TrialRuns::estimatedError(const Method& method, int substeps, const TrialRun& run) const {
  if (steps_ < 2) return 0;
  const std::optional<TrialRun> coarse = runBySteps(method, substeps, 2);
  if (!coarse) return std::numeric_limits<double>::infinity();
  return error(coarse->track, run.track) / (std::exp2(method.order) - 1);
}

double TrialRuns::wantedSteps() const {
  return std::max(1.0, std::ceil(world_.solver.horizon / world_.solver.time_step));
}

Group TrialRuns::groupUnder(const MethodChoice& choice) const {
  return Group(world_, laws_, group_, choice, start_.t, start_states_, start_.laws,
               start_.schedules);
}

/// Substeps that dop853 cannot do without at the start.
double TrialRuns::substepsNeeded() const {
  const Group group = groupUnder({&methodNamed("dop853")});
  return std::min(1e5, group.substepsNeeded(timeStep()));
}

/// [s] When a wrench begins to link the group with bodies outside it.
double TrialRuns::linkedFrom() const {
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t body : group_.members)
    first = std::min(first, start_.schedules[body].nextLink(group_.members));
  return first;
}

std::vector<BodyState> TrialRuns::membersOf(const std::vector<BodyState>& bodies) const {
  std::vector<BodyState> states;
  for (std::size_t body : group_.members) states.push_back(bodies[body]);
  return states;
}

}  // namespace rigid_body_sim
