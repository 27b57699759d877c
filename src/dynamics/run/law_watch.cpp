#include "dynamics/run/law_watch.hpp"

#include <algorithm>

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

std::optional<double> LawWatch::firstEvent(double t, double t_end, const double* own,
                                           const Motion& motion) {
  if (t_end < quiet_until_) return std::nullopt;
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
  while (true) {
    const double middle = before + 0.5 * (after - before);
    if (!(middle > before && middle < after)) return after;
    (isBelow(middle, own, motion) ? after : before) = middle;
  }
}

bool LawWatch::switchModes(double t, double* own, const Motion& motion) const {
  const std::vector<BodyState> states = statesAt(t, motion);
  const ForceLaw::Bodies at{bodies_, states, own};
  constexpr int kMaxSwitches = 100;
  for (int switches = 0; switches < kMaxSwitches; ++switches) {
    const std::size_t guard = firstBelow(*compact_law_, at);
    if (guard == compact_law_->guardCount()) break;
    compact_law_->switchMode(guard, at, own);
  }
  return compact_law_->acts(own);
}

}  // namespace rigid_body_sim
