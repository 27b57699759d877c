#include <algorithm>
#include <set>

#include "dynamics/run/run.hpp"

/// Contacts that start anew, and what is reported of them.
namespace rigid_body_sim {

const std::vector<ContactEvent>& Run::contactEvents() const {
  static const std::vector<ContactEvent> none;
  return contact_events_step_ == steps_ ? contact_events_ : none;
}

/// Puts the own states of contacts to what they are where nothing has happened before.
void Run::startContacts(const std::vector<std::size_t>& laws,
                        const std::vector<BodyState>& bodies) {
  contact_events_step_ = steps_;
  for (std::size_t law : laws) {
    double* own = law_states_.data() + laws_.firstState(law);
    world_->laws[law]->setStart(own);
    const LawWatch watch(*world_, law, laws_.firstState(law));
    watch.switchModes(
        time_, own, [&bodies](std::size_t body, double) { return bodies[body]; }, contact_events_);
  }
}

/// After the state of a body was set from outside.
void Run::restartContacts(std::size_t body) {
  std::set<std::size_t> anew;
  const auto addThose = [&] {
    for (std::size_t law : laws_.of(body))
      if (world_->laws[law]->startsAnew()) anew.insert(law);
  };
  addThose();
  findCandidates(time_);  // where the body is now
  addThose();
  if (anew.empty()) return;
  const std::vector<std::size_t> contacts(anew.begin(), anew.end());
  law_states_ = lawStates();
  const std::vector<double> before = law_states_;
  std::vector<BodyState> bodies;
  for (std::size_t i = 0; i < world_->bodies.size(); ++i) bodies.push_back(this->body(i));
  startContacts(contacts, bodies);
  // others that it neither touched nor touches go on as they are
  std::vector<std::size_t> members{body};
  for (std::size_t law : contacts) {
    const std::size_t first = laws_.firstState(law), count = world_->laws[law]->stateCount();
    const auto own = law_states_.begin() + static_cast<std::ptrdiff_t>(first);
    const bool is_same = std::equal(own, own + static_cast<std::ptrdiff_t>(count),
                                    before.begin() + static_cast<std::ptrdiff_t>(first));
    if (is_same && !world_->laws[law]->acts(law_states_.data() + first)) continue;
    for (std::size_t member : world_->laws[law]->members()) members.push_back(member);
  }
  regroup(members, time_, true);
}

}  // namespace rigid_body_sim
