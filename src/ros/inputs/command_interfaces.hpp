#pragma once

#include <map>
#include <string>

#include <ros/node_handle.h>

#include "ros/inputs/command_intake.hpp"
#include "ros/inputs/input_context.hpp"
#include "ros/inputs/seldom.hpp"
#include "ros/options/node_options.hpp"

namespace rigid_body_sim {

/// The topics <body>/command of the bodies with actuators. Each message is applied in order of
/// arrival, by whoever serves the queue of the handle; those of the lockstep in their turn.
class CommandInterfaces {
 public:
  CommandInterfaces(const ros::NodeHandle& nh, const InputContext& context,
                    const NodeOptions& options);

  /// Takes in a body of the world: if it has actuators, its topic. Gives it back.
  void add(std::size_t body);
  void remove(const std::string& body) { topics_.erase(body); }

 private:
  void take(std::size_t body, const sensor_msgs::JointState& message);
  void warnOfWait(double wait, const std::string& what);

  ros::NodeHandle nh_;
  InputContext context_;
  CommandIntake intake_;
  Seldom warning_;
  std::map<std::string, ros::Subscriber> topics_;  // by body
};

}  // namespace rigid_body_sim
