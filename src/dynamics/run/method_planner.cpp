#include "dynamics/run/method_planner.hpp"

#include <algorithm>

namespace rigid_body_sim {
namespace {

// Bound on the work of each of auto's trial runs, in steps of one body: tenths of a second.
constexpr double kMaxTrialSteps = 3e5;
constexpr double kFullTrials = 10;  // groups that may take so much; more of them share it

bool isSolved(const CoupledBodies& group, unsigned needs) {
  return group.members.size() == 1 && needs == 0;
}

}  // namespace

MethodPlanner::MethodPlanner(const World& world)
    : method_(world.solver.integrator == "auto" ? nullptr : &methodNamed(world.solver.integrator)) {
}

void MethodPlanner::requireSupport(unsigned needs, const std::string& body) const {
  if (method_) rigid_body_sim::requireSupport(*method_, needs, body);
}

void MethodPlanner::requireSupport(const World& world) const {
  if (method_) rigid_body_sim::requireSupport(world);
}

MethodChoice MethodPlanner::atStart(const World& world, const LawTable& laws,
                                    const CoupledBodies& group, const TrialStart& start,
                                    bool scheduled, std::size_t trials) {
  const unsigned needs = needsOf(world, group, start.schedules);
  if (method_ || isSolved(group, needs)) return later(world, group, start.schedules);
  if (needs & kContact) return later(world, group, start.schedules);
  const auto taken = taken_.find(group.members);
  if (taken != taken_.end()) return taken->second;
  const auto known = choices_[scheduled].find(group.members);
  if (known != choices_[scheduled].end()) return known->second;
  const double share = std::min(1.0, kFullTrials / static_cast<double>(trials));
  MethodChoice choice = chooseMethod(world, laws, group, start, share * kMaxTrialSteps);
  choice.max_turn_share = max_turn_share_;
  return choices_[scheduled][group.members] = choice;
}

MethodChoice MethodPlanner::later(const World& world, const CoupledBodies& group,
                                  const std::vector<WrenchSchedule>& schedules) const {
  const unsigned needs = needsOf(world, group, schedules);
  MethodChoice choice;
  if (method_) {
    requireSupport(needs, world.bodies[group.members.front()].name);
    choice.method = method_;
  } else if (!isSolved(group, needs)) {
    choice = errorControlled();
  }
  choice.max_turn_share = max_turn_share_;
  return choice;
}

void MethodPlanner::take(const std::vector<MotionPlan>& plans) {
  for (const MotionPlan& plan : plans) {
    if (plan.integrator.empty()) continue;
    taken_[plan.bodies] = {&methodNamed(plan.integrator),
                           plan.substeps,
                           plan.error,
                           max_turn_share_,
                           plan.holds,
                           plan.tried_until,
                           plan.cut_short,
                           plan.by_estimates};
  }
}

MotionPlan toPlan(const Group& group) {
  const MethodChoice& choice = group.choice();
  MotionPlan plan;
  plan.bodies = group.members();
  if (choice.method) plan.integrator = choice.method->name;
  plan.substeps = choice.substeps;
  plan.by_estimates = choice.by_estimates;
  plan.at_rest = group.isAtRest();
  plan.holds = choice.holds;
  plan.error = choice.error;
  plan.tried_until = choice.tried_until;
  plan.cut_short = choice.cut_short;
  plan.evaluations = group.evaluations();
  return plan;
}

}  // namespace rigid_body_sim
