#include "dynamics/run/run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dynamics/run/linking_step.hpp"

namespace rigid_body_sim {

Run::Run(const std::shared_ptr<const World>& world, const std::shared_ptr<const State>& start)
    : now_(world, RunMotors::complete(*world, start)), grouping_(now_), motors_(*world, *start) {
  const MethodPlanner& planner = grouping_.planner();
  planner.requireSupport(*world);
  contact_trial_.step_bound =
      now_.start->contact_bound > 0 ? now_.start->contact_bound : planner.contactBound();
  contact_trial_.tried_until = now_.start->t;
  place(*now_.start, true);
}

void Run::boundContact(const ContactTrial& trial) {
  contact_trial_ = trial;
  place(*now_.start, true);
}

void Run::limitContactWork(double work) {
  MethodPlanner& planner = grouping_.planner();
  planner.setContactWork(std::min(planner.contactWork(), work));
}

ContactTrial Run::contactTrial() const {
  const double bound = grouping_.planner().contactBound();
  if (bound != contact_trial_.step_bound) return ContactTrial{bound};
  ContactTrial trial = contact_trial_;
  trial.lost_at += now_.horizon_begins;
  trial.tried_until += now_.horizon_begins;
  return trial;
}

Run Run::atTwiceTheStep() const {
  Beside other;
  other.steps = 2;
  other.turn_share = 2;
  other.contact_share = kCompanionShare;
  return beside(other);
}

Run Run::atLooserBounds() const {
  Beside other;
  other.bound_share = other.contact_share = kCompanionShare;
  return beside(other);
}

Run Run::atTighterBounds() const {
  Beside other;
  other.bound_share = other.contact_share = 1 / kCompanionShare;
  other.turn_share = 0.5;
  other.least_substeps = 2;
  return beside(other);
}

Run Run::beside(const Beside& other) const {
  Run run = *this;
  World world = *now_.world;
  world.solver.time_step *= other.steps;
  world.solver.tolerance_stated = false;
  run.now_.world = std::make_shared<const World>(std::move(world));
  run.now_.steps = now_.steps / other.steps;
  run.now_.law_states = now_.lawStates();
  run.grouping_.formBeside(run.now_, now_, other);
  run.now_.beginPacks();
  return run;
}

/// Makes anew what goes by the bodies of the world, where these are to be others.
void Run::enter(const std::vector<BodyChange>& changes) {
  if (changes == now_.changes) return;
  if (now_.changes == now_.start->changes) start_trials_ = grouping_.planner().trials();
  now_.world = std::make_shared<const World>(withChanges(*now_.world, changes));
  now_.changes = changes;
  ++now_.world_changes;
  now_.laws = LawTable(*now_.world);
  grouping_ = Grouping(now_);
  if (changes == now_.start->changes) grouping_.planner().setTrials(start_trials_);
  motors_ = RunMotors(*now_.world, *now_.start);
}

/// Begins at a state. scheduled: with the wrenches and commands of the scene that act or are to
/// come, where the state does not say which those are.
void Run::place(const State& start, bool scheduled) {
  const World& world = *now_.world;
  const double h = world.solver.time_step;
  now_.steps = static_cast<std::int64_t>(std::llround(start.t / h));
  now_.time = static_cast<double>(now_.steps) * h;
  now_.schedules.assign(world.bodies.size(), WrenchSchedule());
  const bool by_world = scheduled && start.schedules.empty();
  if (by_world)
    for (const PointWrench& wrench : world.wrenches)
      now_.schedules[wrench.body].put("", onSteps(wrench, h), 0);
  motors_.place(now_, start, by_world);
  for (std::size_t i = 0; i < start.schedules.size(); ++i)
    now_.schedules[i].restore(start.schedules[i], now_.time);
  for (WrenchSchedule& schedule : now_.schedules) schedule.advanceTo(now_.time);
  now_.law_states = start.laws.empty() ? now_.laws.start(world) : start.laws;
  contacts_.place(now_.steps);
  if (start.laws.empty()) contacts_.start(now_, now_.laws.oneSided(), start.bodies);
  grouping_.planner().setContactBound(start.contact_bound > 0 ? start.contact_bound
                                                              : contact_trial_.step_bound);
  grouping_.planner().setTrial(contact_trial_);
  grouping_.form(now_, start, scheduled);
  now_.beginPacks();
}

/// One step; of groups whose motion is known beyond it only if they are metered.
void Run::advance(ExchangeMeter* meter) {
  const double t_end = static_cast<double>(now_.steps + 1) * now_.world->solver.time_step;
  if (now_.packs.isUsed()) preparePacks(t_end, meter != nullptr);
  advanceGroups(t_end, meter);
  accept(t_end);
}

void Run::stepPart(double t) {
  now_.unpackAll();
  advanceGroups(t, nullptr);
  std::vector<std::size_t> switched;
  if (step_.hasBegun()) switched = acceptGroups(t);
  now_.time = t;
  if (!switched.empty()) grouping_.regroup(now_, switched, t);
}

void Run::advanceGroups(double t_end, ExchangeMeter* meter) {
  const double known_beyond = meter ? std::numeric_limits<double>::infinity() : t_end;
  try {
    if (grouping_.mayChangeBy(t_end))
      LinkingStep(now_, grouping_, contacts_, step_, t_end, meter).advance();
    const std::size_t groups = now_.packs.size() == now_.groups.size() ? 0 : now_.groups.size();
    for (std::size_t g = now_.groups.firstNotKnownBeyond(known_beyond, 0, groups); g < groups;
         g = now_.groups.firstNotKnownBeyond(known_beyond, g + 1, groups)) {
      step_.beginGroup(g, t_end, now_.groups, now_.schedules);
      now_.advance(now_.groups[g], t_end, now_.schedules, meter);
    }
  } catch (...) {
    takeBack();
    throw;
  }
}

void Run::takeBack() {
  const bool regrouped = step_.hasRegrouped();
  step_.takeBack(*now_.world, now_.groups, now_.schedules, now_.law_states);
  if (regrouped) grouping_.findNextLink(now_);
  for (std::size_t body : now_.packs.bodies()) now_.groups.setElsewhere(now_.groups.indexOf(body));
  grouping_.watches().wakeUp();
}

/// Returns the members of groups in which the modes of laws have switched.
std::vector<std::size_t> Run::acceptGroups(double t_end) {
  if (step_.hasRegrouped()) {
    grouping_.findNextLink(now_);
    now_.offerAll();
  }
  for (std::size_t body : step_.scheduled()) now_.packs.offer(body);
  return step_.accept(t_end, now_.groups, now_.schedules);
}

void Run::accept(double t_end) {
  if (step_.hasBegun()) return acceptBegun(t_end);
  endStepAt(t_end);
}

/// Where more has been advanced than motion that is known beforehand.
void Run::acceptBegun(double t_end) {
  const std::vector<std::size_t> switched = acceptGroups(t_end);
  endStepAt(t_end);
  if (!switched.empty()) grouping_.regroup(now_, switched, t_end);
}

void Run::endStepAt(double t_end) {
  now_.time = t_end;
  ++now_.steps;
  if (now_.packs.size() > 0) now_.stepPacks(1);
}

void Run::put(const std::string& slot, const PointWrench& wrench) {
  now_.unpack(wrench.body);
  if (!HeldWrench::holds(wrench)) now_.unpackAll();
  WrenchSchedule& schedule = now_.schedules[wrench.body];
  const bool was_linked = !schedule.allHeld();
  schedule.put(slot, wrench, now_.time);
  grouping_.disturb(now_, wrench.body);
  restartGroup(wrench.body);
  // what it takes the place of may have linked bodies
  if (HeldWrench::holds(wrench) && !was_linked) return;
  std::vector<std::size_t> bodies;
  schedule.addLinked(now_.time, bodies);
  bodies.push_back(wrench.body);
  grouping_.regroup(now_, bodies, now_.time);
  grouping_.findNextLink(now_);
  now_.offerAll();
}

bool Run::clear(std::size_t body, const std::string& slot) {
  WrenchSchedule& schedule = now_.schedules[body];
  const bool all_held = schedule.allHeld();
  if (!(slot.empty() ? schedule.clear() : schedule.clear(slot))) return false;
  now_.unpack(body);
  grouping_.disturb(now_, body);
  restartGroup(body);
  if (!all_held) {
    grouping_.regroup(now_, {body}, now_.time);
    now_.offerAll();
  }
  if (std::isfinite(grouping_.nextLink())) grouping_.findNextLink(now_);
  return true;
}

/// What is to come changes nothing before: the motion stays anchored where it is.
void Run::command(const ActuatorCommand& command) {
  now_.unpack(command.body);
  now_.schedules[command.body].command(command, now_.time);
  grouping_.disturb(now_, command.body);
  if (command.start <= now_.time)
    restartGroup(command.body);
  else
    now_.groups.forgetKnown(now_.groups.indexOf(command.body));
}

void Run::setState(std::size_t body, const BodyState& state) {
  now_.unpack(body);
  grouping_.disturb(now_, body);
  const BodyState now = motors_.follow(now_, body, state);
  restartGroup(body);
  now_.groups.of(body).setState(now_.groups.memberOf(body), now);
  contacts_.restart(now_, grouping_, body);
}

void Run::reset(bool restart_time) {
  enter(now_.start->changes);
  now_.horizon_begins = 0;
  if (restart_time) return place(*now_.start, true);
  State start = *now_.start;
  start.t = now_.time;
  start.schedules.clear();
  start.anchors.clear();
  start.plans.clear();
  start.near_laws.clear();
  const double later = now_.time - now_.start->t;
  now_.horizon_begins = later;
  for (std::vector<ActuatorState>& of_body : start.actuators)
    for (ActuatorState& actuator : of_body) {
      actuator.since += later;
      actuator.until += later;
    }
  place(start, false);
}

void Run::load(const State& state) {
  Run loaded = *this;
  loaded.enter(state.changes);
  loaded.now_.horizon_begins = 0;
  const World& world = *loaded.now_.world;
  const RunMotors motors = loaded.motors_;
  loaded.motors_ = RunMotors(world, state);
  loaded.place(*RunMotors::complete(world, std::make_shared<const State>(state)), true);
  loaded.motors_ = motors;
  *this = std::move(loaded);
}

/// Goes on at a state of a run in a changed world; what has been counted and reported stays. Throws
/// std::invalid_argument, and leaves all as it was, where that run cannot be placed there.
void Run::goOnAs(Run& changed, const State& state) {
  changed.place(state, true);
  changed.now_.groups.setCounts(now_.counts());
  changed.contacts_ = contacts_;
  *this = std::move(changed);
}

/// Begins anew from the present, what acts on a body or its state being another from now on.
void Run::restartGroup(std::size_t body) {
  Group& group = now_.groups.of(body);
  for (std::size_t member : group.members()) now_.schedules[member].advanceTo(now_.time);
  group.restart(now_.time, now_.schedules);
  now_.groups.forgetKnown(now_.groups.indexOf(body));
}

}  // namespace rigid_body_sim
