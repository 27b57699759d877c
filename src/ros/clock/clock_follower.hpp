#pragma once

#include <ros/node_handle.h>
#include <rosgraph_msgs/Clock.h>

namespace rigid_body_sim {

/// The clock that another node sends on /clock, heard by whoever serves the queue of the handle.
class ClockFollower {
 public:
  explicit ClockFollower(ros::NodeHandle nh);

  bool isHeard() const { return heard_; }

  /// What the clock shows; zero until it is heard.
  const ros::Time& now() const { return now_; }

  /// What it showed before; zero until it has been heard twice, and again.
  const ros::Time& before() const { return before_; }

  /// Whether the clock has gone back since this was asked last.
  bool takeSetBack();

 private:
  void hear(const rosgraph_msgs::Clock& message);

  bool heard_ = false;
  bool set_back_ = false;
  ros::Time now_;
  ros::Time before_;
  ros::Subscriber subscriber_;
};

}  // namespace rigid_body_sim
