#pragma once

#include <string>

#include <ros/node_handle.h>
#include <rosgraph_msgs/Clock.h>

namespace rigid_body_sim {

using ClockEvent = ros::MessageEvent<const rosgraph_msgs::Clock>;

/// Warns, once, when more than one node publishes /clock: time would jump between theirs.
class ClockSources {
 public:
  /// A message has come to the subscriber.
  void note(const ClockEvent& event, const ros::Subscriber& subscriber);

 private:
  std::string last_;  // publisher
  bool warned_ = false;
};

}  // namespace rigid_body_sim
