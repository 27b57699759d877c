#include "ros/inputs/command_interfaces.hpp"

#include <stdexcept>

namespace rigid_body_sim {
namespace {

/// Messages that may wait for the next step boundary.
constexpr std::uint32_t kCommandQueue = 1000;

}  // namespace

CommandInterfaces::CommandInterfaces(const ros::NodeHandle& nh, const Simulation& simulation,
                                     Inputs& inputs, const TimeOrigin& origin,
                                     const NodeOptions& options, Refusals& refusals)
    : nh_(nh),
      simulation_(simulation),
      inputs_(inputs),
      origin_(origin),
      refusals_(refusals),
      intake_(simulation.world(), options.command_timeout) {
  if (!options.body_topics) return;
  for (std::size_t body = 0; body < simulation.world().bodies.size(); ++body) add(body);
}

void CommandInterfaces::add(std::size_t body) {
  const Body& added = simulation_.world().bodies[body];
  if (added.actuators.empty()) return;
  using Message = sensor_msgs::JointState;
  const boost::function<void(const Message::ConstPtr&)> callback =
      [this, body](const Message::ConstPtr& message) { take(body, *message); };
  topics_[added.name] =
      nh_.subscribe<Message>(added.name + "/command", kCommandQueue, callback, ros::VoidConstPtr(),
                             ros::TransportHints().tcpNoDelay());
}

void CommandInterfaces::take(std::size_t body, const sensor_msgs::JointState& message) {
  try {
    for (const CommandInput& input : intake_.take(body, message, origin_, simulation_.time()))
      inputs_.apply(input);
  } catch (const std::invalid_argument& refused) {
    refusals_.add("command", refused.what());
  }
}

}  // namespace rigid_body_sim
