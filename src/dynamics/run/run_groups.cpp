#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/actuators/actuator_law.hpp"
#include "dynamics/actuators/actuator_start.hpp"
#include "dynamics/run/run.hpp"

/// Which bodies a run advances together, and how.
namespace rigid_body_sim {

Run::Run(std::shared_ptr<const World> world, std::shared_ptr<const State> start)
    : world_(std::move(world)),
      start_(std::move(start)),
      laws_(*world_),
      planner_(*world_),
      watches_(*world_, laws_) {
  for (const PointWrench& wrench : world_->wrenches)
    if (!HeldWrench::holds(wrench))
      planner_.requireSupport(kCoupling, world_->bodies[wrench.body].name);
  for (const auto& law : world_->laws)
    planner_.requireSupport(law->needs(), world_->bodies[law->members().front()].name);
  if (hasActuators(*world_)) takeActuators();
  planner_.take(start_->plans);
  place(*start_, true);
}

Run Run::atTwiceTheStep() const {
  Run coarse = *this;
  World world = *world_;
  world.solver.time_step *= 2;
  world.solver.tolerance_stated = false;
  coarse.world_ = std::make_shared<const World>(std::move(world));
  coarse.planner_.doubleTurns();
  coarse.steps_ = steps_ / 2;
  coarse.law_states_ = lawStates();
  coarse.watches_ = LawWatches(*coarse.world_, laws_, watches_.near());
  coarse.groups_.clear(world_->bodies.size());
  for (const Group& group : groups_.all()) {
    MethodChoice choice = group.choice();
    choice.max_turn_share *= 2;
    std::vector<BodyState> states;
    for (std::size_t k = 0; k < group.members().size(); ++k) states.push_back(group.at(time_, k));
    coarse.groups_.add(Group(*coarse.world_, laws_, group.bodies(), choice, time_,
                             std::move(states), coarse.law_states_, schedules_),
                       schedules_);
  }
  return coarse;
}

void Run::reset(bool restart_time) {
  if (restart_time) return place(*start_, true);
  State start = *start_;
  start.t = time_;
  start.anchors.clear();
  start.plans.clear();
  for (std::vector<ActuatorState>& of_body : start.actuators)
    for (ActuatorState& actuator : of_body) {
      actuator.since += time_ - start_->t;
      actuator.until += time_ - start_->t;
    }
  place(start, false);
}

/// Begins at a state. scheduled: with the wrenches of the scene that act or are to come.
void Run::place(const State& start, bool scheduled) {
  const double h = world_->solver.time_step;
  steps_ = static_cast<std::int64_t>(std::llround(start.t / h));
  time_ = static_cast<double>(steps_) * h;
  schedules_.assign(world_->bodies.size(), WrenchSchedule());
  if (scheduled)
    for (const PointWrench& wrench : world_->wrenches)
      schedules_[wrench.body].put("", onSteps(wrench, h), 0);
  if (!start.actuators.empty()) placeActuators(start, scheduled);
  for (WrenchSchedule& schedule : schedules_) schedule.advanceTo(time_);
  law_states_ = start.laws.empty() ? laws_.start(*world_) : start.laws;
  contact_events_.clear();
  if (start.laws.empty()) startContacts(laws_.contacts(), start.bodies);
  watches_.restart();
  std::vector<std::size_t> acting;
  for (std::size_t law : laws_.ofPairs())
    if (world_->laws[law]->acts(law_states_.data() + laws_.firstState(law))) acting.push_back(law);
  laws_.setCandidates(*world_, acting);
  formGroups(start, scheduled);
  findNextLink();
}

void Run::formGroups(const State& start, bool scheduled) {
  groups_.clear(world_->bodies.size());
  const std::vector<CoupledBodies> all =
      coupledBodies(*world_, laws_, law_states_, schedules_, movingBodies(*world_));
  const auto trials = std::count_if(all.begin(), all.end(), [this](const CoupledBodies& bodies) {
    return bodies.members.size() > 1 || needsOf(*world_, bodies, schedules_) != 0;
  });
  const TrialStart trial_start{time_, start.bodies, law_states_, schedules_};
  for (const CoupledBodies& bodies : all) {
    const MethodChoice choice = planner_.atStart(*world_, laws_, bodies, trial_start, scheduled,
                                                 static_cast<std::size_t>(trials));
    std::vector<BodyState> states;
    for (std::size_t body : bodies.members) states.push_back(start.bodies[body]);
    Group group(*world_, laws_, bodies, choice, time_, std::move(states), law_states_, schedules_);
    if (!choice.method && !start.anchors.empty())
      group.anchor(start.anchors[bodies.members[0]], schedules_);
    else if (!choice.method && !laws_.contacts().empty())
      group.anchor({time_, start.bodies[bodies.members[0]]}, schedules_);
    const auto isOfGroup = [&bodies](const MotionPlan& plan) {
      return plan.at_rest && plan.bodies == bodies.members;
    };
    if (choice.method && std::any_of(start.plans.begin(), start.plans.end(), isOfGroup))
      group.restAsBefore();
    groups_.add(std::move(group), schedules_);
  }
}

/// Forms the groups of these bodies anew at time t, the present of all of them: what is linked as
/// before goes on as it is.
void Run::regroup(const std::vector<std::size_t>& bodies, double t, bool anew) {
  std::vector<std::size_t> all;
  for (std::size_t g : groups_.indicesOf(*world_, bodies)) {
    const std::vector<std::size_t>& members = groups_[g].members();
    all.insert(all.end(), members.begin(), members.end());
    if (!anew) groups_[g].putLawStates(laws_, law_states_);
  }
  std::sort(all.begin(), all.end());
  std::vector<Group> formed;
  for (const CoupledBodies& linked :
       coupledBodies(*world_, laws_, law_states_, schedules_, all, watches_.near())) {
    const MethodChoice choice = planner_.later(*world_, linked, schedules_);
    const Group& present = groups_.of(linked.members[0]);
    const bool same = present.bodies() == linked;
    const bool solvable = !choice.method;
    if (!anew && same && solvable == !present.choice().method) continue;
    std::vector<BodyState> states;
    for (std::size_t body : linked.members) states.push_back(groups_.at(body, t));
    const BodyState first = states.front();
    formed.push_back(
        Group(*world_, laws_, linked, choice, t, std::move(states), law_states_, schedules_));
    // those who look for contacts ask for its motion at once
    if (solvable && !laws_.contacts().empty()) formed.back().anchor({t, first}, schedules_);
  }
  std::vector<std::size_t> changed;
  for (const Group& group : formed)
    changed.insert(changed.end(), group.members().begin(), group.members().end());
  groups_.remove(groups_.indicesOf(*world_, changed));
  for (Group& group : formed) groups_.add(std::move(group), schedules_);
  watches_.wakeUp(all);
}

void Run::put(const std::string& slot, const PointWrench& wrench) {
  schedules_[wrench.body].put(slot, wrench, time_);
  disturb(wrench.body);
  restartGroup(wrench.body);
  if (HeldWrench::holds(wrench)) return;
  std::vector<std::size_t> bodies;
  schedules_[wrench.body].advanceTo(time_);
  schedules_[wrench.body].addLinked(time_, bodies);
  bodies.push_back(wrench.body);
  regroup(bodies, time_);
  findNextLink();
}

bool Run::clear(std::size_t body, const std::string& slot) {
  const bool all_held = schedules_[body].allHeld();
  if (!(slot.empty() ? schedules_[body].clear() : schedules_[body].clear(slot))) return false;
  disturb(body);
  restartGroup(body);
  if (!all_held) regroup({body}, time_);
  if (std::isfinite(next_link_)) findNextLink();
  return true;
}

/// Begins anew from the present, what acts on a body or its state being another from now on.
void Run::restartGroup(std::size_t body) {
  Group& group = groups_.of(body);
  for (std::size_t member : group.members()) schedules_[member].advanceTo(time_);
  group.restart(time_, schedules_);
  groups_.forgetKnown(groups_.indexOf(body));
}

/// Bodies that act on one another no longer move as the scene predicted.
void Run::disturb(std::size_t body) {
  groups_.of(body).fallBackToErrorControl();
  watches_.wakeUp(groups_.of(body).members());
}

}  // namespace rigid_body_sim
