#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "dynamics/actuators/actuator_start.hpp"
#include "dynamics/contact/buried.hpp"
#include "dynamics/run/check_input.hpp"
#include "dynamics/run/parts.hpp"
#include "dynamics/world_changes.hpp"

/// Bodies that come in and leave while the run goes on.
namespace rigid_body_sim {
namespace {

/// Ends the wrenches and commands of a body, and the wrenches that turn with it.
void clearSchedules(std::size_t body, std::vector<BodySchedule>& schedules) {
  if (schedules.empty()) return;
  schedules[body] = {};
  for (BodySchedule& schedule : schedules) {
    std::vector<ScheduledWrench>& wrenches = schedule.wrenches;
    wrenches.erase(std::remove_if(wrenches.begin(), wrenches.end(),
                                  [body](const ScheduledWrench& entry) {
                                    return entry.wrench.axes == body ||
                                           entry.wrench.point_frame == body;
                                  }),
                   wrenches.end());
  }
}

/// Nothing touches and no tether is taut, before the body is looked at where it comes in.
void startAnew(RunState& run, std::size_t law, std::vector<double>& law_states) {
  run.world->laws[law]->setStart(law_states.data() + run.laws.firstState(law));
  run.law_states = law_states;
}

/// Drops the plans of a body, and of those with which laws link it that act, or may begin to where
/// the others are solved in a medium: they form anew.
void dropPlans(const RunState& run, std::size_t body, std::vector<MotionPlan>& plans) {
  std::vector<std::size_t> linked{body}, watched;
  for (std::size_t i = 0; i < run.world->laws.size(); ++i) {
    const ForceLaw& law = *run.world->laws[i];
    if (!isMember(law, body)) continue;
    std::vector<std::size_t>& to = run.acts(i) ? linked : watched;
    if (!run.acts(i) && !law.isOneSided()) continue;
    const std::vector<std::size_t> members = law.members();
    to.insert(to.end(), members.begin(), members.end());
  }
  const auto hasAny = [](const MotionPlan& plan, const std::vector<std::size_t>& bodies) {
    return std::any_of(bodies.begin(), bodies.end(), [&](std::size_t member) {
      return std::binary_search(plan.bodies.begin(), plan.bodies.end(), member);
    });
  };
  const auto isDropped = [&](const MotionPlan& plan) {
    const bool in_medium = plan.integrator.empty() && !plan.laws.empty();
    return hasAny(plan, linked) || (in_medium && hasAny(plan, watched));
  };
  plans.erase(std::remove_if(plans.begin(), plans.end(), isDropped), plans.end());
}

/// The state of a body whose motors start now, and theirs.
State withMotorsAtStart(const Body& body, const BodyState& state, double t) {
  World alone;
  alone.bodies = {body};
  State start;
  start.t = t;
  start.bodies = {state};
  return withActuators(alone, start);
}

}  // namespace

/// The other groups keep their bits, as after load(); see setMassProperties.
void Run::setPresent(std::size_t body, const std::optional<BodyState>& entering) {
  Run changed = *this;
  if (!entering) {
    changed.now_.unpack(body);
    changed.grouping_.disturb(changed.now_, body);
    changed.restartGroup(body);
  }
  State state = changed.state();
  changed.now_.law_states = state.laws;
  state.changes.resize(now_.world->bodies.size());
  state.changes[body].absent = !entering;
  if (!entering) dropPlans(changed.now_, body, state.plans);
  changed.enter(state.changes);
  changed.grouping_.planner().requireSupport(*changed.now_.world);
  clearSchedules(body, state.schedules);
  state.near_laws.erase(
      std::remove_if(state.near_laws.begin(), state.near_laws.end(),
                     [&](std::size_t law) { return isMember(*now_.world->laws[law], body); }),
      state.near_laws.end());
  state.anchors[body] = {};
  state.bodies[body] = now_.start->bodies[body];
  if (entering) {
    const State start = withMotorsAtStart(changed.now_.world->bodies[body], *entering, now_.time);
    state.bodies[body] = start.bodies[0];
    if (!start.actuators.empty()) state.actuators[body] = start.actuators[0];
    for (std::size_t law : changed.now_.laws.oneSided())
      if (isMember(*changed.now_.world->laws[law], body)) startAnew(changed.now_, law, state.laws);
    dropPlans(changed.now_, body, state.plans);
  }
  goOnAs(changed, state);
  if (entering) contacts_.restart(now_, grouping_, body);
}

/// A body comes in or leaves. body: with the state with which it comes in.
void Simulation::setPresent(std::size_t body, const std::optional<BodyState>& state) {
  checkIndex(world(), body);
  const Body& known = world().bodies[body];
  const std::string who = "body '" + known.name + "' ";
  if (known.fixed) throw std::invalid_argument(who + "is fixed: it is always present");
  if (known.absent == !state)
    throw std::invalid_argument(who + (state ? "is present already" : "is absent already"));
  if (state) {
    World with_body = world();
    with_body.bodies[body].absent = false;
    checkBodyState(with_body, body, *state);
    requireFiniteEnergy(known, *state);
    requireNotBuried(with_body, body, *state);
  }
  const Totals before = parts_->balance ? totalsOf(world(), this->state()) : Totals();
  parts_->run.setPresent(body, state);
  parts_->count();
  if (parts_->balance) parts_->balance->addChange(before, totalsOf(world(), this->state()), true);
  if (parts_->error) parts_->error->restart();
}

}  // namespace rigid_body_sim
