#include "dynamics/run/run_contacts.hpp"

#include <algorithm>
#include <set>

namespace rigid_body_sim {
namespace {

/// Contacts of a body that start anew where its state is set: those that it leaves, too.
std::vector<std::size_t> startingAnew(RunState& run, Grouping& grouping, std::size_t body) {
  std::set<std::size_t> anew;
  for (std::size_t law : run.laws.of(body))
    if (run.world->laws[law]->isOneSided() && run.acts(law)) anew.insert(law);
  grouping.findCandidatesNow(run, run.time);  // where the body is now
  for (std::size_t law : run.laws.of(body))
    if (run.world->laws[law]->isOneSided()) anew.insert(law);
  return {anew.begin(), anew.end()};
}

}  // namespace

const std::vector<ContactEvent>& RunContacts::eventsOf(std::int64_t steps) const {
  static const std::vector<ContactEvent> none;
  if (last_.steps == steps) return last_.events;
  return previous_.steps == steps ? previous_.events : none;
}

std::vector<ContactEvent>& RunContacts::beginStep(std::int64_t steps) {
  if (last_.steps != steps) std::swap(last_, previous_);
  last_.events.clear();
  last_.steps = steps;
  return last_.events;
}

void RunContacts::place(std::int64_t steps) {
  previous_ = {{}, steps};
  last_ = {{}, steps};
}

void RunContacts::start(RunState& run, const std::vector<std::size_t>& laws,
                        const std::vector<BodyState>& bodies) {
  for (std::size_t law : laws)
    run.world->laws[law]->setStart(run.law_states.data() + run.laws.firstState(law));
  switchModes(run, laws, bodies);
}

void RunContacts::switchModes(RunState& run, const std::vector<std::size_t>& laws,
                              const std::vector<BodyState>& bodies) {
  if (last_.steps != run.steps) beginStep(run.steps);
  for (std::size_t law : laws) {
    const std::size_t first = run.laws.firstState(law);
    const LawWatch watch(*run.world, law, first);
    watch.switchModes(
        run.time, run.law_states.data() + first,
        [&bodies](std::size_t body, double) { return bodies[body]; }, last_.events);
  }
}

void RunContacts::restart(RunState& run, Grouping& grouping, std::size_t body) {
  regroup(run, grouping, body, startingAnew(run, grouping, body), true);
}

void RunContacts::follow(RunState& run, Grouping& grouping, std::size_t body) {
  std::vector<std::size_t> laws;
  for (std::size_t law : run.laws.of(body))
    if (run.world->laws[law]->isOneSided()) laws.push_back(law);
  regroup(run, grouping, body, laws, false);
}

/// Forms the groups anew of bodies whose laws change. anew: whether these laws start anew.
void RunContacts::regroup(RunState& run, Grouping& grouping, std::size_t body,
                          const std::vector<std::size_t>& laws, bool anew) {
  if (laws.empty()) return;
  run.law_states = run.lawStates();
  const std::vector<double> before = run.law_states;
  std::vector<BodyState> bodies;
  for (std::size_t i = 0; i < run.world->bodies.size(); ++i) bodies.push_back(run.at(i, run.time));
  if (anew)
    start(run, laws, bodies);
  else
    switchModes(run, laws, bodies);
  std::vector<std::size_t> members{body};
  for (std::size_t law : laws) {
    const std::size_t first = run.laws.firstState(law);
    const auto own = run.law_states.begin() + static_cast<std::ptrdiff_t>(first);
    const bool is_same =
        std::equal(own, own + static_cast<std::ptrdiff_t>(run.world->laws[law]->stateCount()),
                   before.begin() + static_cast<std::ptrdiff_t>(first));
    if (is_same && !run.world->laws[law]->acts(run.law_states.data() + first)) continue;
    for (std::size_t member : run.world->laws[law]->members()) members.push_back(member);
  }
  grouping.regroup(run, members, run.time, true);
}

}  // namespace rigid_body_sim
