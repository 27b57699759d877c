#include <algorithm>

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

/// Whether the motions of all its bodies are known beforehand.
bool Run::isSolved(const LawWatch& watch) const {
  return std::all_of(watch.members().begin(), watch.members().end(), [this](std::size_t body) {
    return !groups_[group_of_[body]].choice().method;
  });
}

/// Whether bodies of which some are integrated may touch before t_end. What acts on them is not
/// known beforehand: within the step they may reverse and double their speed, and fall twice as
/// fast.
bool Run::isNear(const LawWatch& watch, double t, double t_end) const {
  const double h = t_end - t;
  const auto motion = [this](std::size_t body, double at) {
    return groups_[group_of_[body]].at(at, member_of_[body]);
  };
  const auto bound = [&](std::size_t body) {
    const BodyState s = motion(body, t);
    const Body& of = world_->bodies[body];
    MotionBound loose;
    loose.a_off = 4 * s.p_W.norm() / of.mass / h + 2 * world_->g_W.norm();
    loose.torque = (4 * s.L_P.norm() + 4 * radiusOfGyration(of) * s.p_W.norm()) / h;
    loose.until = kNever;
    return std::optional<MotionBound>(loose);
  };
  const double* own = law_states_.data() + watch.firstState();
  return watch.quietInFlight(t, own, motion, bound) < t_end;
}

/// At the start of a step, lets bodies go that are linked for no more than being near, where they
/// are no longer; the same for a run that is taken up here.
void Run::partFromNear(double t_end) {
  for (const LawWatch& watch : watches_) {
    const auto kept = near_.find(watch.law());
    if (kept == near_.end()) continue;
    law_states_ = lawStates();
    const bool acts = world_->laws[watch.law()]->acts(law_states_.data() + watch.firstState());
    if (!acts && isNear(watch, time_, t_end)) continue;
    near_.erase(kept);
    if (!acts) regroup(watch.members(), time_);
  }
}

/// After the state of a body was set from outside.
void Run::restartContacts(std::size_t body) {
  std::vector<std::size_t> contacts;
  for (std::size_t law : laws_.of(body))
    if (world_->laws[law]->startsAnew()) contacts.push_back(law);
  if (contacts.empty()) return;
  law_states_ = lawStates();
  std::vector<BodyState> bodies;
  for (std::size_t i = 0; i < world_->bodies.size(); ++i) bodies.push_back(this->body(i));
  startContacts(contacts, bodies);
  std::vector<std::size_t> members;
  for (std::size_t law : contacts)
    for (std::size_t member : world_->laws[law]->members()) members.push_back(member);
  regroup(members, time_, true);
}

}  // namespace rigid_body_sim
