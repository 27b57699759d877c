#include "dynamics/run/method_planner.hpp"

#include <algorithm>
#include <stdexcept>

#include "dynamics/run/contact_bound.hpp"

namespace rigid_body_sim {
namespace {

// Bound on the work of each of auto's trial runs, in steps of one body: tenths of a second.
constexpr double kMaxTrialSteps = 3e5;
constexpr double kFullTrials = 10;  // groups that may take so much; more of them share it

/// Body by body, whether a law may begin to act on it that finds that by bounds on its motion,
/// which drag has not.
std::vector<bool> watchedBodies(const World& world) {
  std::vector<bool> watched(world.bodies.size());
  for (const auto& law : world.laws)
    if (law->isOneSided())
      for (std::size_t body : law->members()) watched[body] = true;
  return watched;
}

/// Whether a wrench or a command acts on the group or is to come.
bool isScheduled(const World& world, const CoupledBodies& group,
                 const std::vector<WrenchSchedule>& schedules) {
  return std::any_of(group.members.begin(), group.members.end(), [&](std::size_t body) {
    const ActuatorSchedule* actuators = schedules[body].actuators();
    return schedules[body].size() > 0 || (actuators && actuators->commandsToCome() > 0) ||
           std::any_of(world.commands.begin(), world.commands.end(),
                       [body](const ActuatorCommand& command) { return command.body == body; });
  });
}

/// What a trial has found, where its start has moved in time.
MethodChoice startedAt(double t, const MethodPlanner::Trials::Found& found) {
  MethodChoice choice = found.choice;
  choice.tried_until += t - found.start;
  return choice;
}

}  // namespace

MethodPlanner::MethodPlanner(const World& world)
    : method_(world.solver.integrator == "auto" ? nullptr : &methodNamed(world.solver.integrator)),
      watched_(watchedBodies(world)),
      tolerance_(world.solver.tolerance) {
  bounds_.contact_bound = contactStepBound(tolerance_);
  bounds_.contact_work = maxContactWork(world.solver.time_step);
}

void MethodPlanner::change(const Beside& beside) {
  bounds_ = changedBy(beside, bounds_);
  least_substeps_ = beside.least_substeps;
}

void MethodPlanner::setContactBound(double bound) {
  bounds_.contact_bound = bound;
  bounds_.bound_share = bound / contactStepBound(tolerance_);
}

void MethodPlanner::setTrial(const ContactTrial& trial) {
  regroups_ = trial.regroups;
  whole_run_tried_ = trial.is_made && trial.compares;
}

/// Whatever the bounds were when it was found.
MethodChoice MethodPlanner::bounded(MethodChoice choice) const {
  choice.max_turn_share = bounds_.max_turn_share;
  choice.bound_share = bounds_.bound_share;
  choice.contact_bound = bounds_.contact_bound;
  choice.contact_work = bounds_.contact_work;
  choice.holds |= choice.by_estimates && whole_run_tried_;
  if (choice.by_estimates) choice.substeps = std::max(choice.substeps, least_substeps_);
  return choice;
}

/// A body under held wrenches, by itself or, where it is on no pivot, in a medium.
bool MethodPlanner::isSolved(const World& world, const CoupledBodies& group, unsigned needs,
                             const std::vector<WrenchSchedule>& schedules) const {
  if (group.members.size() != 1) return false;
  if (needs == 0) return true;
  const WrenchSchedule& schedule = schedules[group.members[0]];
  return !watched_[group.members[0]] && !world.bodies[group.members[0]].pivoted &&
         !schedule.actuators() && schedule.allHeld() &&
         std::all_of(group.laws.begin(), group.laws.end(),
                     [&world](std::size_t law) { return world.laws[law]->isOfMedium(); });
}

bool MethodPlanner::isWatched(const CoupledBodies& group) const {
  return std::any_of(group.members.begin(), group.members.end(),
                     [this](std::size_t body) { return watched_[body]; });
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
  if (method_ || isSolved(world, group, needs, start.schedules))
    return later(world, group, start.schedules);
  if (needs & kContact || (regroups_ && isWatched(group)))
    return later(world, group, start.schedules);
  auto& found =
      scheduled && isScheduled(world, group, start.schedules) ? trials_.with : trials_.without;
  if (const auto known = found.find(group.members); known != found.end())
    return bounded(scheduled ? known->second.choice : startedAt(start.t, known->second));
  const double share = std::min(1.0, kFullTrials / static_cast<double>(trials));
  const MethodChoice choice = chooseMethod(world, laws, group, start, share * kMaxTrialSteps);
  found[group.members] = {start.t, choice};
  return bounded(choice);
}

MethodChoice MethodPlanner::later(const World& world, const CoupledBodies& group,
                                  const std::vector<WrenchSchedule>& schedules) const {
  const unsigned needs = needsOf(world, group, schedules);
  MethodChoice choice;
  if (method_) {
    requireSupport(needs, world.bodies[group.members.front()].name);
    choice.method = method_;
  } else if (!isSolved(world, group, needs, schedules)) {
    choice = errorControlled();
  }
  return bounded(choice);
}

bool MethodPlanner::fits(const std::vector<MotionPlan>& plans) const {
  return !plans.empty() &&
         (!method_ || std::all_of(plans.begin(), plans.end(), [this](const auto& plan) {
           return plan.integrator == method_->name;
         }));
}

MethodChoice MethodPlanner::asPlanned(const World& world, const CoupledBodies& group,
                                      const std::vector<WrenchSchedule>& schedules,
                                      const MotionPlan& plan) const {
  const std::string& body = world.bodies[group.members.front()].name;
  const auto isHere = [&group](std::size_t frame) {
    return frame == kWorld || std::binary_search(group.members.begin(), group.members.end(), frame);
  };
  for (std::size_t member : group.members)
    for (const PointWrench& wrench : schedules[member].active())
      if (!isHere(wrench.axes) || !isHere(wrench.point_frame))
        throw std::invalid_argument("body '" + world.bodies[member].name +
                                    "': a plan must have the bodies with which a wrench links it");
  const unsigned needs = needsOf(world, group, schedules);
  if (!plan.integrator.empty()) {
    const Method& method = methodNamed(plan.integrator);
    // also where nothing acts yet, so that it would be solved
    rigid_body_sim::requireSupport(method, needs | needsAhead(world, group, schedules), body);
    return bounded({&method, plan.substeps, plan.error, 1, plan.holds, plan.tried_until,
                    plan.cut_short, plan.by_estimates});
  }
  if (!isSolved(world, group, needs, schedules))
    throw std::invalid_argument("body '" + body + "': its motion cannot be solved with what acts");
  return bounded({});
}

MotionPlan toPlan(const Group& group) {
  const MethodChoice& choice = group.choice();
  MotionPlan plan;
  plan.bodies = group.members();
  plan.laws = group.bodies().laws;
  plan.waiting_laws = group.bodies().waiting;
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
