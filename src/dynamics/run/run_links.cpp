#include <algorithm>
#include <cmath>

#include "dynamics/run/run.hpp"

/// Instants within a step at which bodies are linked or part: by wrenches, and by laws that begin
/// or cease to act.
namespace rigid_body_sim {

void Run::findNextLink() {
  next_link_ = kNever;
  for (const WrenchSchedule& schedule : schedules_)
    next_link_ = std::min(next_link_, schedule.nextCoupling());
}

/// The bodies that wrenches link or part at time t, and those at the other end.
std::vector<std::size_t> Run::linkedFrom(double t) const {
  std::vector<std::size_t> bodies;
  for (std::size_t body = 0; body < schedules_.size(); ++body)
    if (schedules_[body].nextCoupling() <= t) schedules_[body].addLinked(t, bodies);
  return bodies;
}

void Run::watchLaws() {
  watches_.clear();
  for (std::size_t law : laws_.guarded())
    watches_.emplace_back(*world_, law, laws_.firstState(law));
  watch_from_ = watches_.empty() ? kNever : kNotKnown;
}

/// Those of laws on these bodies; ascending.
void Run::wakeWatches(const std::vector<std::size_t>& bodies) {
  for (LawWatch& watch : watches_) {
    const auto isHere = [&bodies](std::size_t body) {
      return std::binary_search(bodies.begin(), bodies.end(), body);
    };
    if (!std::any_of(watch.members().begin(), watch.members().end(), isHere)) continue;
    watch.wakeUp();
    watch_from_ = kNotKnown;
  }
}

/// Whether its law does not act, nor belong to a group that looks after it.
bool Run::isWatched(const LawWatch& watch) const {
  if (world_->laws[watch.law()]->acts(law_states_.data() + watch.firstState())) return false;
  const Group& group = groups_[group_of_[watch.members().front()]];
  return !(group.mayStop() && group.follows(watch.law()));
}

void Run::findNextWatch() {
  watch_from_ = kNever;
  for (const LawWatch& watch : watches_)
    if (isWatched(watch)) watch_from_ = std::min(watch_from_, watch.quietUntil());
  for (const Group& group : groups_)
    if (group.mayStop()) watch_from_ = kNotKnown;
}

/// The state of a body at a time within the step.
BodyState Run::bodyAt(std::size_t body, double t) const {
  if (world_->bodies[body].fixed) return start_->bodies[body];
  const std::size_t g = group_of_[body];
  if (t < known_until_[g] || t <= std::max(time_, groups_[g].time()))
    return groups_[g].at(t, member_of_[body]);
  Group group = groups_[g];
  std::vector<WrenchSchedule> schedules = schedules_;
  advance(group, t, schedules);
  return group.advanced().bodies[member_of_[body]];
}

/// The first instant up to t_end at which a law begins to act.
std::optional<Run::WatchedEvent> Run::firstWatchedEvent(double t_end) {
  const auto motion = [this](std::size_t body, double t) { return bodyAt(body, t); };
  const auto bound = [this](std::size_t body) {
    return groups_[group_of_[body]].motionBound(schedules_);
  };
  std::optional<WatchedEvent> first;
  for (LawWatch& watch : watches_) {
    const double until = first ? first->t : t_end;
    if (until < watch.quietUntil() || !isWatched(watch)) continue;
    double from = time_;
    for (std::size_t body : watch.members()) from = std::max(from, groups_[group_of_[body]].time());
    if (!(from < until)) continue;
    const double* own = law_states_.data() + watch.firstState();
    if (!isSolved(watch)) {
      if (watch.members().size() > 1 && isNear(watch, from, until))
        first = WatchedEvent{&watch, from, true};
      if (watch.members().size() > 1) continue;
    }
    try {
      if (const std::optional<double> t = watch.firstEvent(from, until, own, motion, bound))
        first = WatchedEvent{&watch, *t};
    } catch (const StepTooLong& reason) {
      throw SimulationDiverged(from, world_->bodies[watch.members().front()].name, reason.what());
    }
  }
  return first;
}

/// Advances those groups that wrenches link or part within the step, or a law that begins or ceases
/// to act, to that instant, and forms them anew there.
template <class... Meter>
void Run::advanceLinking(double t_end, Meter&... meter) {
  step_.law_states = lawStates();
  contact_events_.clear();
  contact_events_step_ = steps_ + 1;
  partFromNear(t_end);
  constexpr int kMaxLinks = 100000;
  for (int links = 0;; ++links) {
    if (links == kMaxLinks)
      throw SimulationDiverged(time_, world_->bodies[0].name,
                               "a step links and parts bodies 100000 times");
    if (links > 0) findNextLink();
    const double limit = std::min(t_end, next_link_);
    if (const std::optional<WatchedEvent> event = firstWatchedEvent(limit)) {
      advanceTo(event->t, t_end, event->watch->members(), meter...);
      if (event->links) {
        near_.insert(event->watch->law());
        regroup(event->watch->members(), event->t);
        continue;
      }
      event->watch->switchModes(
          event->t, law_states_.data() + event->watch->firstState(),
          [this](std::size_t body, double t) { return bodyAt(body, t); }, contact_events_);
      regroup(event->watch->members(), event->t);
    } else if (!advanceContact(limit, t_end, meter...)) {
      if (!(next_link_ <= t_end)) break;
      const double t = next_link_;
      const std::vector<std::size_t> bodies = linkedFrom(t);
      advanceTo(t, t_end, bodies, meter...);
      regroup(bodies, t);
    }
  }
  std::stable_sort(contact_events_.begin(), contact_events_.end(),
                   [](const ContactEvent& a, const ContactEvent& b) { return a.t < b.t; });
  findNextWatch();
}

/// Advances the groups with contact to the limit, or until one of them stops where a contact begins
/// or ceases to act. Returns whether one did.
template <class... Meter>
bool Run::advanceContact(double limit, double t_end, Meter&... meter) {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (!groups_[g].mayStop() || !(std::max(time_, groups_[g].time()) < limit)) continue;
    const std::vector<std::size_t> members = groups_[g].members();
    const double stop = advanceGroup(g, limit, t_end, meter...);
    if (!groups_[g].switchedModes()) continue;
    regroup(members, stop);
    return true;
  }
  return false;
}

/// Advances the groups of these bodies to an instant t within the step, for good or until the step
/// is taken back.
template <class... Meter>
void Run::advanceTo(double t, double t_end, const std::vector<std::size_t>& bodies,
                    Meter&... meter) {
  for (std::size_t g : groupsOf(bodies)) advanceGroup(g, t, t_end, meter...);
}

/// Returns where it has led to, t unless the group stops before.
template <class... Meter>
double Run::advanceGroup(std::size_t g, double t, double t_end, Meter&... meter) {
  begin(g, t_end);
  step_.advanced.pop_back();  // it is another by the end of the step
  const std::size_t first = groups_[g].members().front();
  const bool is_found =
      groups_[g].time() <= time_ &&
      std::none_of(step_.regrouped.begin(), step_.regrouped.end(), [&](const Group& kept) {
        return std::binary_search(kept.members().begin(), kept.members().end(), first);
      });
  if (is_found) step_.regrouped.push_back(groups_[g]);
  advance(groups_[g], t, schedules_, meter...);
  const double reached = groups_[g].advancedTo(t);
  groups_[g].accept(reached);
  groups_[g].moveContactEvents(contact_events_);
  return reached;
}

template void Run::advanceLinking(double);
template void Run::advanceLinking(double, ExchangeMeter&);

}  // namespace rigid_body_sim
