#include "dynamics/run/law_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "dynamics/step_too_long.hpp"

namespace rigid_body_sim {
namespace {

/// The first guard that is below zero; their number where none is.
std::size_t firstBelow(const ForceLaw& law, const ForceLaw::Bodies& at) {
  std::vector<double> guards(law.guardCount());
  law.setGuards(at, guards.data());
  const auto below = std::find_if(guards.begin(), guards.end(), [](double g) { return g < 0; });
  return static_cast<std::size_t>(below - guards.begin());
}

}  // namespace

LawWatch::LawWatch(const World& world, std::size_t law, std::size_t first_state)
    : law_(law), first_state_(first_state), members_(world.laws[law]->members()) {
  std::sort(members_.begin(), members_.end());
  members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
  for (std::size_t body : members_) bodies_.push_back(&world.bodies[body]);
  compact_law_ = world.laws[law]->reindexed([this](std::size_t body) {
    return static_cast<std::size_t>(std::lower_bound(members_.begin(), members_.end(), body) -
                                    members_.begin());
  });
}

std::vector<BodyState> LawWatch::statesAt(double t, const Motion& motion) const {
  std::vector<BodyState> states;
  for (std::size_t body : members_) states.push_back(motion(body, t));
  return states;
}

bool LawWatch::isBelow(double t, const double* own, const Motion& motion) const {
  const std::vector<BodyState> states = statesAt(t, motion);
  return firstBelow(*compact_law_, {bodies_, states, own}) < compact_law_->guardCount();
}

/// Whether the motions of all bodies are bounded.
bool LawWatch::gatherBounds(const Bound& bound) {
  bounds_.clear();
  for (std::size_t body : members_) {
    const std::optional<MotionBound> of_body = bound(body);
    if (!of_body) return false;
    bounds_.push_back(*of_body);
  }
  return true;
}

std::optional<double> LawWatch::firstEvent(double t, double t_end, const double* own,
                                           const Motion& motion, const Bound& bound) {
  if (t_end < quiet_until_) return std::nullopt;
  if (compact_law_->isOneSided() && gatherBounds(bound)) {
    const double bounded = std::min(t_end, boundedUntil());
    const std::optional<double> event = certifiedEvent(t, bounded, own, motion);
    if (event || bounded == t_end) return event;
    t = bounded;  // something else acts from there on
  }
  return sampledEvent(t, t_end, own, motion);
}

double LawWatch::boundedUntil() const {
  double until = std::numeric_limits<double>::infinity();
  for (const MotionBound& bound : bounds_) until = std::min(until, bound.until);
  return until;
}

std::optional<double> LawWatch::sampledEvent(double t, double t_end, const double* own,
                                             const Motion& motion) {
  const std::vector<BodyState> now = statesAt(t, motion);
  quiet_until_ = compact_law_->quietUntil(t, {bodies_, now, own});
  if (t_end < quiet_until_) return std::nullopt;
  double before = t, after = t;
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    after = share < 1 ? t + share * (t_end - t) : t_end;
    if (isBelow(after, own, motion)) break;
    if (share == 1) return std::nullopt;
    before = after;
  }
  return firstBelowAfter(before, after, own, motion);
}

double LawWatch::quietInFlight(double t, const double* own, const Motion& motion,
                               const Bound& bound) const {
  std::vector<MotionBound> bounds;
  for (std::size_t body : members_) bounds.push_back(*bound(body));
  const std::vector<BodyState> now = statesAt(t, motion);
  return compact_law_->quietInFlight(t, {bodies_, now, own}, bounds);
}

bool LawWatch::mayAct(const double* own, const RoamOf& roam) const {
  std::vector<BodyState> states;
  std::vector<Stray> strays;
  for (std::size_t body : members_) {
    const Roam& of_body = roam(body);
    states.push_back(of_body.from);
    strays.push_back({of_body.place, of_body.turn, 0, 0});
  }
  return !compact_law_->holdsStill({bodies_, states, own}, strays);
}

/// By halves, to rounding; a guard is below zero at `after`.
double LawWatch::firstBelowAfter(double before, double after, const double* own,
                                 const Motion& motion) const {
  while (true) {
    const double middle = before + 0.5 * (after - before);
    if (!(middle > before && middle < after)) return after;
    (isBelow(middle, own, motion) ? after : before) = middle;
  }
}

/// From bound to bound, each from where the last one ends: they reach an event by Newton's way, and
/// pass by whatever comes near without one. Where rounding lets them go no further, small steps
/// look for a guard below zero.
std::optional<double> LawWatch::certifiedEvent(double t, double t_end, const double* own,
                                               const Motion& motion) {
  constexpr int kMaxBounds = 1000000;
  constexpr double kSmall = 1e-15;  // [s], and relative
  const double least = kSmall * std::max(1.0, std::abs(t_end));
  double step = least;
  for (int bounds = 0; bounds < kMaxBounds; ++bounds) {
    const std::vector<BodyState> now = statesAt(t, motion);
    quiet_until_ = compact_law_->quietInFlight(t, {bodies_, now, own}, bounds_);
    if (t_end < quiet_until_) return std::nullopt;
    if (quiet_until_ - t > least) {
      t = quiet_until_;
      step = least;
      continue;
    }
    if (isBelow(t, own, motion)) return t;
    const double next = std::min(t + step, t_end);
    if (isBelow(next, own, motion)) return firstBelowAfter(t, next, own, motion);
    if (next == t_end) {
      quiet_until_ = t_end;
      return std::nullopt;
    }
    t = next;
    step *= 2;
  }
  throw StepTooLong(std::string("a ") + compact_law_->name() +
                    " comes near to act too often to be followed");
}

void LawWatch::switchModes(double t, double* own, const Motion& motion,
                           std::vector<ContactEvent>& events) const {
  const std::vector<BodyState> states = statesAt(t, motion);
  const ForceLaw::Bodies at{bodies_, states, own};
  const std::vector<double> before(own, own + compact_law_->stateCount());
  const std::size_t first = events.size(), most = 100 + 4 * compact_law_->guardCount();
  for (std::size_t switches = 0; switches < most; ++switches) {
    const std::size_t guard = firstBelow(*compact_law_, at);
    if (guard == compact_law_->guardCount()) break;
    compact_law_->switchMode(guard, at, own);
  }
  compact_law_->addContactEvents(at, before.data(), events);
  for (std::size_t i = first; i < events.size(); ++i) events[i].t = t;
}

}  // namespace rigid_body_sim
