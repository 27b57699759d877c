#include "ros/inputs/inputs.hpp"

#include <utility>

#include "ros/inputs/input_messages.hpp"

namespace rigid_body_sim {

Inputs::Inputs(Topic<Input> topic, const std::string& world_frame, Simulation& simulation,
               const TimeOrigin& origin)
    : world_frame_(world_frame),
      simulation_(simulation),
      origin_(origin),
      topic_(std::move(topic)) {}

void Inputs::apply(Input input) {
  applyInput(input, world_frame_, simulation_);
  if (input.kind == Input::RESTART) {
    ++run_;
    number_ = 0;
  }
  input.run = run_;
  input.number = number_++;
  if (!topic_.heard()) return;
  input.header.stamp = stamp();
  input.header.frame_id = world_frame_;
  input.step = static_cast<std::uint64_t>(simulation_.steps());
  input.time = simulation_.time();
  topic_.publish(input, input.header.stamp);
}

}  // namespace rigid_body_sim
