#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include "reference_run.hpp"

namespace rigid_body_sim {

/// Drives a node that was started paused, through its services, and receives what it says. Nothing
/// here sleeps: every wait is for a message.
class NodeDriver {
 public:
  explicit NodeDriver(const std::vector<std::string>& bodies);

  /// Steps until odometry and tf of a step arrive, so that both are known to be connected.
  /// Returns the number of steps.
  int connect();

  /// Waits for the odometry of every body and the tf that belong to the steps.
  /// Returns the stamp of the state reached.
  ros::Time step(unsigned steps);

  void pause(bool paused);
  void reset();

  /// Serves callbacks until the condition holds; false after a generous time.
  static bool waitFor(const std::function<bool()>& condition, double seconds = 20);

  Motion motion(const std::string& body) const;
  const nav_msgs::Odometry& odometry(const std::string& body) const;
  const geometry_msgs::TransformStamped& transform(const std::string& body) const;

  /// Stamps of all odometry of the first body, in order of arrival, without repetitions of the
  /// standing state, be it one that a reset has changed.
  const std::vector<ros::Time>& stamps() const { return stamps_; }

  /// Transforms of the last TFMessage.
  std::size_t transformsAtOnce() const { return transforms_at_once_; }

 private:
  bool receivedAll(const ros::Time& stamp) const;

  ros::NodeHandle nh_;
  std::vector<std::string> bodies_;
  ros::ServiceClient step_;
  ros::ServiceClient pause_;
  ros::ServiceClient reset_;
  std::vector<ros::Subscriber> subscribers_;
  std::map<std::string, nav_msgs::Odometry> odometry_;
  std::map<std::string, geometry_msgs::TransformStamped> transforms_;
  std::vector<ros::Time> stamps_;
  bool was_reset_ = false;  // and no later time has been received since
  std::size_t transforms_at_once_ = 0;
};

}  // namespace rigid_body_sim
