#include <algorithm>
#include <set>
#include <utility>

#include "dynamics/packs/in_parts.hpp"
#include "dynamics/run/linking_step.hpp"
#include "dynamics/run/run.hpp"

/// What a run is asked: its state, now and within the next step.
namespace rigid_body_sim {

/// Empty where there are none and the world schedules none.
std::vector<BodySchedule> Run::scheduleEntries() const {
  const auto hasAny = [](const WrenchSchedule& schedule) {
    return schedule.size() > 0 ||
           (schedule.actuators() && schedule.actuators()->commandsToCome() > 0);
  };
  const bool any = !now_.world->wrenches.empty() || !now_.world->commands.empty() ||
                   std::any_of(now_.schedules.begin(), now_.schedules.end(), hasAny);
  std::vector<BodySchedule> entries;
  if (!any) return entries;
  entries.reserve(now_.schedules.size());
  for (const WrenchSchedule& schedule : now_.schedules) entries.push_back(schedule.entries());
  return entries;
}

void Run::readBodies(std::vector<BodyState>& states, bool backward) const {
  states.resize(now_.world->bodies.size());
  now_.packs.copyTo(states);
  if (now_.packs.size() == states.size()) return;
  constexpr std::size_t kLeastReads = 4096;  // bodies, by one thread: some 200 us
  inParts(states.size(), 1,
          worthwhileThreads(now_.world->solver.threads, states.size(), kLeastReads),
          [&](std::size_t first, std::size_t end) { readGroups(first, end, backward, states); });
}

/// Of the bodies [first, end) those that are in no pack.
void Run::readGroups(std::size_t first, std::size_t end, bool backward,
                     std::vector<BodyState>& states) const {
  FlightBatch batch;
  constexpr std::size_t kAhead = 8;  // bodies
  const auto bodyAt = [&](std::size_t k) { return backward ? end - 1 - k : first + k; };
  for (std::size_t k = 0; k < end - first; ++k) {
    const std::size_t i = bodyAt(k), ahead = bodyAt(std::min(k + kAhead, end - 1 - first));
    if (now_.groups.has(ahead)) now_.groups.of(ahead).announceRead();
    if (now_.packs.holds(i)) continue;
    if (!now_.groups.has(i))
      states[i] = now_.start->bodies[i];
    else if (!now_.groups.of(i).readFlight(now_.time, batch, states[i]))
      states[i] = now_.groups.at(i, now_.time);
  }
  batch.finish();
}

/// Without what a run needs to go on with the same bits.
State Run::present() const {
  State state;
  state.t = now_.time;
  state.changes = now_.changes;
  state.laws = now_.lawStates();
  state.actuators = motors_.states(now_.schedules);
  readBodies(state.bodies);
  return state;
}

State Run::state() const {
  State state = present();
  state.schedules = scheduleEntries();
  const std::set<std::size_t>& near = grouping_.watches().near();
  state.near_laws.assign(near.begin(), near.end());
  if (!now_.laws.oneSided().empty()) state.contact_bound = grouping_.planner().contactBound();
  state.anchors.resize(now_.world->bodies.size());
  for (std::size_t g = 0; g < now_.groups.size(); ++g) {
    const Group& group = now_.groups[g];
    for (std::size_t k = 0; k < group.members().size(); ++k)
      state.anchors[group.members()[k]] = group.anchorOf(k);
    state.plans.push_back(now_.planOf(g));
  }
  for (std::size_t body : now_.packs.bodies())
    state.anchors[body] = {now_.time, state.bodies[body], Groups::kNotKnown};
  return state;
}

State Run::sample(double t) const {
  if (t <= now_.time) return present();
  if (grouping_.mayChangeBy(t)) return goneOnTo(t).present();
  State sampled;
  sampled.t = t;
  sampled.changes = now_.changes;
  sampled.laws = now_.lawStates();
  sampled.bodies = now_.start->bodies;
  std::vector<WrenchSchedule> schedules;
  for (std::size_t g = 0; g < now_.groups.size(); ++g) {
    const std::vector<std::size_t>& members = now_.groups[g].members();
    if (!now_.packs.holds(members.front()) && t < now_.groups.knownUntil(g)) {
      for (std::size_t k = 0; k < members.size(); ++k)
        sampled.bodies[members[k]] = now_.groups[g].at(t, k);
      continue;
    }
    if (schedules.empty()) schedules = now_.schedules;
    Group group = now_.groupNow(g);
    now_.advance(group, t, schedules, nullptr);
    group.accept(t);
    for (std::size_t k = 0; k < members.size(); ++k)
      sampled.bodies[members[k]] = group.present().bodies[k];
    if (!sampled.laws.empty()) group.putLawStates(now_.laws, sampled.laws);
  }
  sampled.actuators = motors_.states(schedules.empty() ? now_.schedules : schedules);
  return sampled;
}

/// A copy that goes on to a time between now and the next step, through whatever links or parts
/// bodies meanwhile.
Run Run::goneOnTo(double t) const {
  Run copy = *this;
  copy.now_.unpackAll();
  if (!(t > now_.time)) return copy;
  LinkingStep(copy.now_, copy.grouping_, copy.contacts_, copy.step_, t, nullptr).advance();
  for (Group& group : copy.now_.groups.all()) {
    copy.now_.advance(group, t, copy.now_.schedules, nullptr);
    group.accept(t);
  }
  copy.now_.time = t;
  return copy;
}

}  // namespace rigid_body_sim
