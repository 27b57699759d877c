#include "inputs.hpp"

#include "input_messages.hpp"

namespace rigid_body_sim {
namespace {

/// Inputs that may wait for a listener: a second at 10 000 a second.
constexpr std::uint32_t kQueueSize = 10000;

}  // namespace

Inputs::Inputs(ros::NodeHandle private_nh, const std::string& world_frame, Simulation& simulation,
               const TimeOrigin& origin)
    : world_frame_(world_frame),
      simulation_(simulation),
      origin_(origin),
      publisher_(private_nh.advertise<Input>("inputs", kQueueSize)) {}

void Inputs::apply(Input input) {
  applyInput(input, world_frame_, simulation_);
  if (input.kind == Input::RESTART) {
    ++run_;
    number_ = 0;
  }
  input.run = run_;
  input.number = number_++;
  if (publisher_.getNumSubscribers() == 0) return;
  input.header.stamp = origin_.stamp(simulation_.time());
  input.header.frame_id = world_frame_;
  input.step = static_cast<std::uint64_t>(simulation_.steps());
  input.time = simulation_.time();
  publisher_.publish(input);
}

}  // namespace rigid_body_sim
