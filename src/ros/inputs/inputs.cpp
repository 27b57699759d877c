#include "ros/inputs/inputs.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include <ros/console.h>

#include "dynamics/wrenches/delay.hpp"
#include "ros/inputs/input_messages.hpp"

namespace rigid_body_sim {
namespace {

/// More than a person or a program applies at one instant.
constexpr std::size_t kMaxHeld = 100000;

/// Whether what was applied before has nothing to do with the run from here on.
bool beginsRun(const SimulationInput& input) {
  const auto* reset = std::get_if<ResetInput>(&input);
  return (reset && reset->restart_time) || std::holds_alternative<LoadInput>(input);
}

/// A wrench or a command that comes late as the simulation delays it, so that the record says when
/// it acts; nothing for other inputs.
std::optional<SimulationInput> delayedTo(double t, const SimulationInput& input) {
  const auto isLate = [t](double start) { return start < t && std::isfinite(start); };
  if (const auto* wrench = std::get_if<WrenchInput>(&input)) {
    if (!isLate(wrench->wrench.start)) return std::nullopt;
    WrenchInput late = *wrench;
    delayTo(t, late.wrench);
    return late;
  }
  if (const auto* command = std::get_if<CommandInput>(&input)) {
    if (!isLate(command->command.start)) return std::nullopt;
    CommandInput late = *command;
    delayTo(t, late.command);
    return late;
  }
  return std::nullopt;
}

}  // namespace

Inputs::Inputs(Topic<Input> record, const std::string& world_frame, Simulation& simulation,
               const TimeOrigin& origin, double clock_period, Listener listener,
               Preparation prepare)
    : world_frame_(world_frame),
      simulation_(simulation),
      origin_(origin),
      clock_period_(clock_period),
      prepare_(std::move(prepare)),
      listener_(std::move(listener)),
      record_(std::move(record)) {}

void Inputs::apply(const SimulationInput& input) {
  if (prepare_) prepare_();
  const std::optional<SimulationInput> delayed = delayedTo(simulation_.time(), input);
  applyInTime(delayed ? *delayed : input);
}

void Inputs::applyInTime(const SimulationInput& input) {
  simulation_.apply(input);
  if (beginsRun(input)) {
    ++run_;
    number_ = 0;
    held_.clear();
    clock_runs_at_.reset();
  }
  if (listener_) listener_(input);  // first: stamps may have moved
  if (record_.subscribers()) record(input);
  ++number_;
}

void Inputs::record(const SimulationInput& input) {
  Input message = toMessage(input, simulation_.world(), world_frame_);
  message.header.stamp = stamp();
  message.header.frame_id = world_frame_;
  message.run = run_;
  message.number = number_;
  message.step = static_cast<std::uint64_t>(simulation_.steps());
  message.time = simulation_.time();
  if (!message.header.stamp.isZero() && held_.empty())
    record_.publish(message, message.header.stamp);
  else if (held_.size() < kMaxHeld)
    held_.push_back(message);
  else
    ROS_WARN_ONCE("more than %zu inputs at time zero: the record on ~inputs lacks some", kMaxHeld);
}

void Inputs::recordHeld(Clock::time_point now) {
  if (held_.empty() || simulation_.time() <= 0 || simulation_.time() < clock_period_) return;
  if (!clock_runs_at_) clock_runs_at_ = now + kClockDelay;
  if (now < *clock_runs_at_) return;
  for (const Input& message : held_) record_.publish(message, message.header.stamp);
  held_.clear();
}

}  // namespace rigid_body_sim
