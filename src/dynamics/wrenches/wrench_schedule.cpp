#include "dynamics/wrenches/wrench_schedule.hpp"

#include <algorithm>

namespace rigid_body_sim {

void WrenchSchedule::put(const std::string& slot, PointWrench wrench, double now) {
  if (wrench.start < now) {
    wrench.end += now - wrench.start;
    wrench.start = now;
  }
  if (!slot.empty()) {
    for (std::size_t i = 0; i < active_.size(); ++i)
      if (active_slots_[i] == slot) active_[i].end = std::min(active_[i].end, wrench.start);
    for (auto it = pending_.begin(); it != pending_.end();) {
      const bool same = it->second.slot == slot;
      if (same) it->second.wrench.end = std::min(it->second.wrench.end, wrench.start);
      it = same && it->second.wrench.end <= it->first ? pending_.erase(it) : std::next(it);
    }
  }
  if (wrench.end > wrench.start) pending_.emplace(wrench.start, Pending{slot, wrench});
  findNextEvent();
}

bool WrenchSchedule::clear() {
  const bool any = size() > 0;
  active_.clear();
  active_slots_.clear();
  pending_.clear();
  findNextEvent();
  return any;
}

bool WrenchSchedule::clear(const std::string& slot) {
  const std::size_t before = size();
  for (std::size_t i = active_.size(); i-- > 0;) {
    if (active_slots_[i] != slot) continue;
    active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(i));
    active_slots_.erase(active_slots_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (auto it = pending_.begin(); it != pending_.end();)
    it = it->second.slot == slot ? pending_.erase(it) : std::next(it);
  findNextEvent();
  return size() < before;
}

bool WrenchSchedule::holds(const std::string& slot) const {
  return std::find(active_slots_.begin(), active_slots_.end(), slot) != active_slots_.end() ||
         std::any_of(pending_.begin(), pending_.end(),
                     [&slot](const auto& entry) { return entry.second.slot == slot; });
}

bool WrenchSchedule::advanceTo(double t) {
  if (t < next_event_) return false;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < active_.size(); ++i) {
    if (active_[i].end <= t) continue;
    active_[kept] = active_[i];
    std::swap(active_slots_[kept], active_slots_[i]);
    ++kept;
  }
  active_.resize(kept);
  active_slots_.resize(kept);
  while (!pending_.empty() && pending_.begin()->first <= t) {
    Pending& first = pending_.begin()->second;
    if (before_) before_->started.emplace_back(*pending_.begin());
    if (first.wrench.end > t) {
      active_.push_back(first.wrench);
      active_slots_.push_back(std::move(first.slot));
    }
    pending_.erase(pending_.begin());
  }
  findNextEvent();
  return true;
}

void WrenchSchedule::beginStep() { before_ = Before{active_, active_slots_, {}}; }

void WrenchSchedule::takeBack() {
  active_ = std::move(before_->active);
  active_slots_ = std::move(before_->active_slots);
  for (auto& started : before_->started) pending_.insert(std::move(started));
  before_.reset();
  findNextEvent();
}

void WrenchSchedule::accept() { before_.reset(); }

bool WrenchSchedule::allHeld() const {
  return std::all_of(active_.begin(), active_.end(), HeldWrench::holds) &&
         std::all_of(pending_.begin(), pending_.end(),
                     [](const auto& entry) { return HeldWrench::holds(entry.second.wrench); });
}

std::vector<std::size_t> WrenchSchedule::bodies() const {
  std::vector<std::size_t> bodies;
  const auto add = [&bodies](const PointWrench& wrench) {
    for (std::size_t body : {wrench.body, wrench.axes, wrench.point_frame})
      if (body != kWorld) bodies.push_back(body);
  };
  for (const PointWrench& wrench : active_) add(wrench);
  for (const auto& [start, pending] : pending_) add(pending.wrench);
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

void WrenchSchedule::findNextEvent() {
  next_event_ = std::numeric_limits<double>::infinity();
  for (const PointWrench& wrench : active_) next_event_ = std::min(next_event_, wrench.end);
  if (!pending_.empty()) next_event_ = std::min(next_event_, pending_.begin()->first);
}

}  // namespace rigid_body_sim
