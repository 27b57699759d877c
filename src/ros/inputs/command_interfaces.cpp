#include "ros/inputs/command_interfaces.hpp"

namespace rigid_body_sim {

CommandInterfaces::CommandInterfaces(const ros::NodeHandle& nh, const InputContext& context,
                                     const NodeOptions& options)
    : nh_(nh), context_(context), intake_(context.simulation.world(), options.command_timeout) {
  if (!options.body_topics) return;
  for (std::size_t body = 0; body < context.simulation.world().bodies.size(); ++body) add(body);
}

void CommandInterfaces::add(std::size_t body) {
  const Body& added = context_.simulation.world().bodies[body];
  if (added.actuators.empty()) return;
  using Message = sensor_msgs::JointState;
  topics_[added.name] = context_.subscribe<Message>(
      nh_, added.name + "/command", [this, body](const Message& message) { take(body, message); });
}

void CommandInterfaces::take(std::size_t body, const sensor_msgs::JointState& message) {
  context_.apply("command",
                 [&](double now) { return intake_.take(body, message, context_.origin, now); });
}

}  // namespace rigid_body_sim
