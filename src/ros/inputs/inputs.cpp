#include "ros/inputs/inputs.hpp"

#include <utility>

#include "ros/inputs/input_messages.hpp"

namespace rigid_body_sim {
namespace {

bool restartsTime(const SimulationInput& input) {
  const auto* reset = std::get_if<ResetInput>(&input);
  return reset && reset->restart_time;
}

}  // namespace

Inputs::Inputs(Topic<Input> record, const std::string& world_frame, Simulation& simulation,
               const TimeOrigin& origin, Listener listener)
    : world_frame_(world_frame),
      simulation_(simulation),
      origin_(origin),
      listener_(std::move(listener)),
      record_(std::move(record)) {}

void Inputs::apply(const SimulationInput& input) {
  simulation_.apply(input);
  if (restartsTime(input)) {
    ++run_;
    number_ = 0;
  }
  if (record_.heard()) record(input);
  ++number_;
  if (listener_) listener_(input);
}

void Inputs::record(const SimulationInput& input) {
  Input message = toMessage(input, simulation_.world(), world_frame_);
  message.header.stamp = stamp();
  message.header.frame_id = world_frame_;
  message.run = run_;
  message.number = number_;
  message.step = static_cast<std::uint64_t>(simulation_.steps());
  message.time = simulation_.time();
  record_.publish(message, message.header.stamp);
}

}  // namespace rigid_body_sim
