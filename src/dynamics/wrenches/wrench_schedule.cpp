#include "dynamics/wrenches/wrench_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/wrenches/delay.hpp"

namespace rigid_body_sim {

double onStep(double t, double h) {
  const double step = std::round(t / h) * h;
  return std::abs(t - step) <= 4 * std::numeric_limits<double>::epsilon() * std::abs(step) ? step
                                                                                           : t;
}

PointWrench onSteps(PointWrench wrench, double h) {
  const double duration = wrench.end - wrench.start;
  const double start = onStep(wrench.start, h), end = onStep(wrench.end, h);
  if (!(end > start)) return wrench;  // shorter than what is rounding there
  const double share = (end - start) / duration;
  if (std::abs(share - 1) > kImpulseRounding) {
    wrench.force /= share;
    wrench.torque /= share;
  }
  wrench.start = start;
  wrench.end = end;
  return wrench;
}

namespace {

void nameOwnBody(PointWrench& wrench) {
  if (wrench.axes == kOwnBody) wrench.axes = wrench.body;
  if (wrench.point_frame == kOwnBody) wrench.point_frame = wrench.body;
}

}  // namespace

void WrenchSchedule::put(const std::string& slot, PointWrench wrench, double now) {
  nameOwnBody(wrench);
  delayTo(now, wrench);
  if (!slot.empty()) {
    for (std::size_t i = 0; i < active_.size(); ++i)
      if (active_slots_[i] == slot) active_[i].end = std::min(active_[i].end, wrench.start);
    for (auto it = pending_.begin(); it != pending_.end();) {
      const bool same = it->second.slot == slot;
      if (same) it->second.wrench.end = std::min(it->second.wrench.end, wrench.start);
      it = same && it->second.wrench.end <= it->first ? pending_.erase(it) : std::next(it);
    }
  }
  couples_ |= !HeldWrench::holds(wrench);
  if (wrench.end > wrench.start) pending_.emplace(wrench.start, Pending{slot, wrench});
  findNextEvent();
}

void WrenchSchedule::setActuators(ActuatorSchedule actuators) {
  actuators_ = std::move(actuators);
  findNextEvent();
}

BodySchedule WrenchSchedule::entries() const {
  BodySchedule entries;
  entries.wrenches.reserve(size());
  for (std::size_t i = 0; i < active_.size(); ++i)
    entries.wrenches.push_back({active_slots_[i], active_[i]});
  for (const auto& [start, pending] : pending_)
    entries.wrenches.push_back({pending.slot, pending.wrench});
  if (actuators_) entries.commands = actuators_->toCome();
  return entries;
}

void WrenchSchedule::restore(const BodySchedule& entries, double t) {
  for (const ScheduledWrench& entry : entries.wrenches) {
    PointWrench wrench = entry.wrench;
    nameOwnBody(wrench);
    couples_ |= !HeldWrench::holds(wrench);
    if (wrench.start > t) {
      pending_.emplace(wrench.start, Pending{entry.slot, wrench});
    } else {
      active_.push_back(wrench);
      active_slots_.push_back(entry.slot);
    }
  }
  for (const ActuatorCommand& command : entries.commands) actuators_->put(command, t);
  findNextEvent();
}

void WrenchSchedule::command(const ActuatorCommand& command, double now) {
  actuators_->put(command, now);
  findNextEvent();
}

void WrenchSchedule::followJump(const Vector3d& w_before_P, const Vector3d& w_after_P, double t) {
  if (!actuators_) return;
  actuators_->followJump(w_before_P, w_after_P, t);
  findNextEvent();
}

bool WrenchSchedule::clear() {
  const bool any = size() > 0;
  active_.clear();
  active_slots_.clear();
  pending_.clear();
  couples_ = false;
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
  if (actuators_) actuators_->advanceTo(t);
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

std::vector<PointWrench> WrenchSchedule::activeAt(double t) const {
  WrenchSchedule later(*this);
  later.advanceTo(t);
  return later.active_;
}

void WrenchSchedule::beginStep() {
  before_ = Before{active_, active_slots_, {}};
  if (actuators_) actuators_->beginStep();
}

void WrenchSchedule::takeBack() {
  active_ = std::move(before_->active);
  active_slots_ = std::move(before_->active_slots);
  for (auto& started : before_->started) pending_.insert(std::move(started));
  before_.reset();
  if (actuators_) actuators_->takeBack();
  findNextEvent();
}

void WrenchSchedule::accept() {
  before_.reset();
  if (actuators_) actuators_->accept();
}

bool WrenchSchedule::allHeld() const {
  return std::all_of(active_.begin(), active_.end(), HeldWrench::holds);
}

double WrenchSchedule::nextLink(const std::vector<std::size_t>& bodies) const {
  const auto isOutside = [&bodies](std::size_t frame) {
    return frame != kWorld && !std::binary_search(bodies.begin(), bodies.end(), frame);
  };
  if (couples_)
    for (const auto& [start, pending] : pending_)
      if (isOutside(pending.wrench.axes) || isOutside(pending.wrench.point_frame)) return start;
  return std::numeric_limits<double>::infinity();
}

void WrenchSchedule::addLinked(double t, std::vector<std::size_t>& bodies) const {
  const auto add = [&bodies](const PointWrench& wrench) {
    for (std::size_t body : {wrench.body, wrench.axes, wrench.point_frame})
      if (body != kWorld) bodies.push_back(body);
  };
  for (const PointWrench& wrench : active_)
    if (!HeldWrench::holds(wrench)) add(wrench);
  for (const auto& [start, pending] : pending_) {
    if (start > t) break;
    if (!HeldWrench::holds(pending.wrench)) add(pending.wrench);
  }
}

void WrenchSchedule::findNextEvent() {
  next_event_ = next_coupling_ = std::numeric_limits<double>::infinity();
  for (const PointWrench& wrench : active_) {
    next_event_ = std::min(next_event_, wrench.end);
    if (!HeldWrench::holds(wrench)) next_coupling_ = std::min(next_coupling_, wrench.end);
  }
  if (!pending_.empty()) next_event_ = std::min(next_event_, pending_.begin()->first);
  if (actuators_) next_event_ = std::min(next_event_, actuators_->nextEvent());
  if (!couples_) return;
  for (const auto& [start, pending] : pending_) {
    if (HeldWrench::holds(pending.wrench)) continue;
    next_coupling_ = std::min(next_coupling_, start);
    return;
  }
}

}  // namespace rigid_body_sim
