#include "dynamics/run/linking_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

LinkingStep::LinkingStep(RunState& run, Grouping& grouping, RunContacts& contacts,
                         StepRecord& record, double t_end, ExchangeMeter* meter)
    : run_(run),
      grouping_(grouping),
      record_(record),
      contact_events_(contacts.beginStep(run.steps + 1)),
      t_end_(t_end),
      meter_(meter) {}

void LinkingStep::advance() {
  begin();
  constexpr int kMaxLinks = 100000;
  const double done = run_.groups.work();
  const double most = grouping_.planner().contactWork();
  for (int links = 0; advanceToNext(); ++links) {
    // each looks at every group
    const double looks = static_cast<double>(links) * static_cast<double>(run_.groups.size());
    if (run_.groups.work() - done + looks > most) stopAt(tooMuchContact(most));
    if (links == kMaxLinks) stopAt("a step links and parts bodies 100000 times");
  }
  std::stable_sort(contact_events_.begin(), contact_events_.end(),
                   [](const ContactEvent& a, const ContactEvent& b) { return a.t < b.t; });
  settle();
  grouping_.watches().findQuiet(run_);
}

void LinkingStep::stopAt(const std::string& reason) const {
  throw SimulationDiverged(run_.time, run_.world->bodies[0].name, reason);
}

/// Parts bodies that were linked for no more than being near, where they are no longer; the same
/// for a run that is taken up here.
void LinkingStep::begin() {
  record_.beginRegrouping(run_.groups, run_.lawStates());
  if (grouping_.watches().near().empty()) return grouping_.findCandidates(run_, t_end_);
  grouping_.findCandidatesNow(run_, t_end_);
  run_.law_states = run_.lawStates();
  const std::vector<std::size_t> parted = grouping_.watches().forgetFar(run_, t_end_);
  if (!parted.empty()) grouping_.regroup(run_, parted, run_.time);
}

/// Advances to the earliest instant at which groups form or part, and forms them anew there. False
/// where there is none up to the end.
bool LinkingStep::advanceToNext() {
  const double link = grouping_.nextLink(), limit = std::min(t_end_, link);
  grouping_.findCandidates(run_, limit);
  if (const auto event = grouping_.watches().firstEvent(run_, limit)) {
    advanceToEvent(*event);
  } else if (!advanceContact(limit)) {
    if (!(link <= t_end_)) return false;
    const std::vector<std::size_t> bodies = Grouping::linkedBy(link, run_);
    if (advanceTo(link, bodies)) grouping_.regroup(run_, bodies, link);
  }
  grouping_.findNextLink(run_);
  return true;
}

/// Advances the bodies of a law to the instant from which on it acts.
void LinkingStep::advanceToEvent(const LawWatches::Event& event) {
  const LawWatch& watch = *event.watch;
  const std::vector<std::size_t> members = watch.members();  // regrouping looks for laws anew
  if (!advanceTo(event.t, members)) return;
  if (event.is_near)
    grouping_.watches().setNear(watch);
  else
    watch.switchModes(
        event.t, run_.law_states.data() + watch.firstState(),
        [this](std::size_t body, double t) { return run_.at(body, t); }, contact_events_);
  grouping_.regroup(run_, members, event.t);
}

/// Advances the groups with contact to the limit, or until one of them stops where a contact begins
/// or ceases to act. Returns whether one did.
bool LinkingStep::advanceContact(double limit) {
  Groups& groups = run_.groups;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const bool moves = groups[g].mayStop() ||
                       (groups[g].isAtRest() && groups[g].restsUntil(run_.schedules) <= limit);
    if (!moves || !(std::max(run_.time, groups[g].time()) < limit)) continue;
    const std::vector<std::size_t> members = groups[g].members();
    const double stop = advanceGroup(g, limit);
    if (!groups[g].switchedModes()) continue;
    grouping_.regroup(run_, members, stop);
    return true;
  }
  return false;
}

/// Advances the groups of these bodies to an instant t within the step, for good or until the step
/// is taken back. False where one of them stops before, because a contact begins or ceases to act.
bool LinkingStep::advanceTo(double t, const std::vector<std::size_t>& bodies) {
  for (std::size_t g : run_.groups.indicesOf(*run_.world, bodies)) {
    const std::vector<std::size_t> members = run_.groups[g].members();
    const double stop = advanceGroup(g, t);
    if (!run_.groups[g].switchedModes() || !(stop < t)) continue;
    grouping_.regroup(run_, members, stop);
    return false;
  }
  return true;
}

/// Returns where it has led to, t unless the group stops before.
double LinkingStep::advanceGroup(std::size_t g, double t) {
  record_.beginGroup(g, t_end_, run_.groups, run_.schedules);
  record_.keepGroup(g, run_.time, run_.groups);
  Group& group = run_.groups[g];
  const PairSweep& pairs = grouping_.watches().pairs();
  if (pairs.hasLaws() && (group.mayStop() || group.isAtRest())) {
    std::vector<Roam> roams;
    for (std::size_t body : group.members()) roams.push_back(pairs.roam(body));
    group.setRoams(std::move(roams));
  }
  run_.advance(group, t, run_.schedules, meter_);
  const double reached = group.advancedTo(t);
  group.accept(reached);
  group.moveContactEvents(contact_events_);
  return reached;
}

/// Puts groups to rest that have come to it; looked for at steps of the world 20 ms apart.
void LinkingStep::settle() {
  constexpr double kPeriod = 0.02;  // [s]
  const double h = run_.world->solver.time_step;
  const std::int64_t step = run_.steps + 1;
  const auto every = static_cast<std::int64_t>(std::ceil(std::max(kPeriod / h, 1.0)));
  if (step % every != 0 || t_end_ != static_cast<double>(step) * h) return;
  for (std::size_t g = 0; g < run_.groups.size(); ++g) {
    Group& group = run_.groups[g];
    if (!group.mayStop()) continue;
    if (meter_)
      group.settle(*meter_);
    else
      group.settle();
    if (group.isAtRest()) run_.groups.findKnownOrRest(g, run_.schedules);
  }
}

}  // namespace rigid_body_sim
