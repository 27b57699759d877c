#include "ros/inputs/command_interfaces.hpp"

#include <vector>

#include <ros/console.h>

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

/// A stamp of wall time lies ahead of a simulation that was paused. wait: [s]
void CommandInterfaces::warnOfWait(double wait, const std::string& what) {
  constexpr double kLong = 1;  // [s]
  if (wait > kLong && warning_.isDue())
    ROS_WARN("%s is stamped %.3g s ahead of simulation time: it waits until then", what.c_str(),
             wait);
}

void CommandInterfaces::take(std::size_t body, const sensor_msgs::JointState& message) {
  const std::string what =
      "command on " + context_.simulation.world().bodies[body].name + "/command";
  context_.apply(what.c_str(), [&](double now) {
    std::vector<CommandInput> commands = intake_.take(body, message, context_.origin, now);
    warnOfWait(commands.front().command.start - now, what);
    return commands;
  });
}

}  // namespace rigid_body_sim
