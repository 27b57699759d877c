#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dynamics/run/run.hpp"

/// Instants within a step at which bodies are linked or part: by wrenches, and by laws that begin
/// or cease to act.
namespace rigid_body_sim {

void Run::findNextLink() {
  next_link_ = std::numeric_limits<double>::infinity();
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

/// The state of a body at a time within the step.
BodyState Run::bodyAt(std::size_t body, double t) const {
  if (world_->bodies[body].fixed) return start_->bodies[body];
  const std::size_t g = groups_.indexOf(body);
  if (t < groups_.knownUntil(g) || t <= std::max(time_, groups_[g].time()))
    return groups_.at(body, t);
  Group group = groups_[g];
  std::vector<WrenchSchedule> schedules = schedules_;
  advance(group, t, schedules);
  return group.advanced().bodies[groups_.memberOf(body)];
}

WatchedRun Run::watched() const {
  return {
      *world_, laws_, groups_, schedules_, law_states_, time_, [this](std::size_t body, double t) {
        return bodyAt(body, t);
      }};
}

/// Lets everything know which laws may act up to t_end that need bodies to be near each other.
void Run::findCandidates(double t_end) {
  if (watches_.findCandidates(watched(), t_end))
    laws_.setCandidates(*world_, watches_.pairs().candidates());
}

/// Before bodies are linked or parted within a step. Parts those that were linked for no more than
/// being near, where they are no longer; the same for a run that is taken up here.
void Run::beginLinking(double t_end) {
  step_.beginRegrouping(groups_, lawStates());
  contact_events_.clear();
  contact_events_step_ = steps_ + 1;
  findCandidates(t_end);
  if (watches_.near().empty()) return;
  law_states_ = lawStates();
  const std::vector<std::size_t> parted = watches_.forgetFar(watched(), t_end);
  if (!parted.empty()) regroup(parted, time_);
}

/// Advances those groups that wrenches link or part within the step, or a law that begins or ceases
/// to act, to that instant, and forms them anew there.
template <class... Meter>
void Run::advanceLinking(double t_end, Meter&... meter) {
  beginLinking(t_end);
  constexpr int kMaxLinks = 100000;
  for (int links = 0;; ++links) {
    if (links == kMaxLinks)
      throw SimulationDiverged(time_, world_->bodies[0].name,
                               "a step links and parts bodies 100000 times");
    if (links > 0) findNextLink();
    const double limit = std::min(t_end, next_link_);
    findCandidates(limit);
    if (const auto event = watches_.firstEvent(watched(), limit)) {
      advanceToEvent(*event, t_end, meter...);
    } else if (!advanceContact(limit, t_end, meter...)) {
      if (!(next_link_ <= t_end)) break;
      const double t = next_link_;
      const std::vector<std::size_t> bodies = linkedFrom(t);
      if (advanceTo(t, t_end, bodies, meter...)) regroup(bodies, t);
    }
  }
  std::stable_sort(contact_events_.begin(), contact_events_.end(),
                   [](const ContactEvent& a, const ContactEvent& b) { return a.t < b.t; });
  settle(t_end, meter...);
  watches_.findQuiet(watched());
}

/// Puts groups to rest that have come to it; looked for at steps of the world 20 ms apart.
template <class... Meter>
void Run::settle(double t_end, Meter&... meter) {
  constexpr double kPeriod = 0.02;  // [s]
  const double h = world_->solver.time_step;
  const auto every = static_cast<std::int64_t>(std::ceil(std::max(kPeriod / h, 1.0)));
  if ((steps_ + 1) % every != 0 || t_end != static_cast<double>(steps_ + 1) * h) return;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (!groups_[g].mayStop()) continue;
    groups_[g].settle(meter...);
    if (groups_[g].isAtRest()) groups_.findKnownOrRest(g, schedules_);
  }
}

/// Advances the bodies of a law to the instant from which on it acts.
template <class... Meter>
void Run::advanceToEvent(const LawWatches::Event& event, double t_end, Meter&... meter) {
  const LawWatch& watch = *event.watch;
  if (!advanceTo(event.t, t_end, watch.members(), meter...)) return;
  if (event.is_near)
    watches_.setNear(watch);
  else
    watch.switchModes(event.t, law_states_.data() + watch.firstState(), watched().motion,
                      contact_events_);
  regroup(watch.members(), event.t);
}

/// Advances the groups with contact to the limit, or until one of them stops where a contact begins
/// or ceases to act. Returns whether one did.
template <class... Meter>
bool Run::advanceContact(double limit, double t_end, Meter&... meter) {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const bool moves = groups_[g].mayStop() ||
                       (groups_[g].isAtRest() && groups_[g].restsUntil(schedules_) <= limit);
    if (!moves || !(std::max(time_, groups_[g].time()) < limit)) continue;
    const std::vector<std::size_t> members = groups_[g].members();
    const double stop = advanceGroup(g, limit, t_end, meter...);
    if (!groups_[g].switchedModes()) continue;
    regroup(members, stop);
    return true;
  }
  return false;
}

/// Advances the groups of these bodies to an instant t within the step, for good or until the step
/// is taken back. False where one of them stops before, because a contact begins or ceases to act.
template <class... Meter>
bool Run::advanceTo(double t, double t_end, const std::vector<std::size_t>& bodies,
                    Meter&... meter) {
  for (std::size_t g : groups_.indicesOf(*world_, bodies)) {
    const std::vector<std::size_t> members = groups_[g].members();
    const double stop = advanceGroup(g, t, t_end, meter...);
    if (!groups_[g].switchedModes() || !(stop < t)) continue;
    regroup(members, stop);
    return false;
  }
  return true;
}

/// Returns where it has led to, t unless the group stops before.
template <class... Meter>
double Run::advanceGroup(std::size_t g, double t, double t_end, Meter&... meter) {
  step_.beginGroup(g, t_end, groups_, schedules_);
  step_.keepGroup(g, time_, groups_);
  if (watches_.pairs().hasLaws() && groups_[g].mayStop()) {
    std::vector<Roam> roams;
    for (std::size_t body : groups_[g].members()) roams.push_back(watches_.pairs().roam(body));
    groups_[g].setRoams(std::move(roams));
  }
  advance(groups_[g], t, schedules_, meter...);
  const double reached = groups_[g].advancedTo(t);
  groups_[g].accept(reached);
  groups_[g].moveContactEvents(contact_events_);
  return reached;
}

template void Run::advanceLinking(double);
template void Run::advanceLinking(double, ExchangeMeter&);

}  // namespace rigid_body_sim
