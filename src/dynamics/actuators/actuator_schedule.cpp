#include "dynamics/actuators/actuator_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigid_body_sim {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Time constants after which a lag is below a rounding of a rounding, e⁻⁴⁰ = 4e-18 of what it was:
/// the value counts as the command from there on.
constexpr double kSettled = 40;

bool lags(const ActuatorEntry& entry, const ActuatorState& state) {
  return entry.kind != ActuatorEntry::Kind::kWheel && state.value != state.command;
}

/// [s] when a speed that is to reverse passes zero: Ω = u + (Ω₀ − u) ε = 0.
double reversalOf(const ActuatorEntry& entry, const ActuatorState& state) {
  if (entry.kind != ActuatorEntry::Kind::kRotor || !(state.value * state.command < 0))
    return kNever;
  return state.since + entry.time_constant * std::log1p(-state.value / state.command);
}

}  // namespace

ActuatorSchedule::ActuatorSchedule(std::shared_ptr<const ActuatorTable> table,
                                   std::vector<ActuatorState> states)
    : table_(std::move(table)), states_(std::move(states)) {
  for (std::size_t k = 0; k < states_.size(); ++k)
    if (!((*table_)[k].time_constant > 0) && (*table_)[k].kind != ActuatorEntry::Kind::kWheel)
      states_[k].value = states_[k].command;
  findNextEvent();
}

void ActuatorSchedule::put(ActuatorCommand command, double now) {
  if (command.start < now) {
    command.end += now - command.start;
    command.start = now;
  }
  if (command.end > command.start) pending_.emplace(command.start, command);
  findNextEvent();
}

std::vector<ActuatorCommand> ActuatorSchedule::toCome() const {
  std::vector<ActuatorCommand> commands;
  for (const auto& [start, command] : pending_) commands.push_back(command);
  return commands;
}

bool ActuatorSchedule::advanceTo(double t) {
  if (t < next_event_) return false;
  while (next_event_ <= t) {
    const double now = next_event_;
    for (std::size_t k = 0; k < states_.size(); ++k)
      if (nextOf(k) <= now) passEvent(k, now);
    while (!pending_.empty() && pending_.begin()->first <= now) {
      if (before_) before_->started.push_back(*pending_.begin());
      start(pending_.begin()->second, now);
      pending_.erase(pending_.begin());
    }
    findNextEvent();
  }
  return true;
}

void ActuatorSchedule::start(const ActuatorCommand& command, double t) {
  const ActuatorEntry& entry = (*table_)[command.actuator];
  const double u = std::min(std::max(command.value, entry.least), entry.greatest);
  ActuatorState& state = states_[command.actuator];
  // said again, it changes nothing: a lag that began anew with each of many would never end
  if (u != state.command) setCommand(command.actuator, u, t);
  if (u != command.value) ++state.saturations;
  state.until = command.end;
}

void ActuatorSchedule::setCommand(std::size_t k, double u, double t) {
  const ActuatorEntry& entry = (*table_)[k];
  ActuatorState& state = states_[k];
  const bool follows = entry.kind != ActuatorEntry::Kind::kWheel && !(entry.time_constant > 0);
  state.value = follows ? u : valueOf(entry, state, t);
  state.command = u;
  state.since = t;
}

/// [s] The next event of an actuator that is not a command.
double ActuatorSchedule::nextOf(std::size_t k) const {
  const ActuatorEntry& entry = (*table_)[k];
  const ActuatorState& state = states_[k];
  if (!lags(entry, state)) return state.until;
  const double settled = state.since + kSettled * entry.time_constant;
  return std::min({state.until, settled, reversalOf(entry, state)});
}

void ActuatorSchedule::passEvent(std::size_t k, double t) {
  const ActuatorEntry& entry = (*table_)[k];
  ActuatorState& state = states_[k];
  const bool reverses = reversalOf(entry, state) <= t;
  if (reverses || lags(entry, state)) {
    const bool settles = state.since + kSettled * entry.time_constant <= t;
    if (settles) state.value = state.command;
    if (reverses && !settles) state.value = 0;
    if (settles || reverses) state.since = t;
  }
  if (!(state.until <= t)) return;
  setCommand(k, entry.rest(), t);
  state.until = kNever;
}

void ActuatorSchedule::findNextEvent() {
  next_event_ = kNever;
  if (!pending_.empty()) next_event_ = pending_.begin()->first;
  for (std::size_t k = 0; k < states_.size(); ++k) next_event_ = std::min(next_event_, nextOf(k));
}

void ActuatorSchedule::followJump(const Vector3d& w_before_P, const Vector3d& w_after_P, double t) {
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const ActuatorEntry& entry = (*table_)[k];
    if (entry.kind != ActuatorEntry::Kind::kWheel) continue;
    setCommand(k, states_[k].command, t);
    states_[k].value += entry.inertia * entry.momentum_P.dot(w_after_P - w_before_P);
  }
  findNextEvent();
}

void ActuatorSchedule::beginStep() { before_ = Before{states_, {}}; }

void ActuatorSchedule::takeBack() {
  states_ = std::move(before_->states);
  // to the front of those of the same start, in their order
  for (auto it = before_->started.rbegin(); it != before_->started.rend(); ++it)
    pending_.emplace_hint(pending_.lower_bound(it->first), *it);
  before_.reset();
  findNextEvent();
}

}  // namespace rigid_body_sim
