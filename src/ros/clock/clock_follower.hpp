#pragma once

#include <ros/node_handle.h>

#include "ros/clock/clock_sources.hpp"

namespace rigid_body_sim {

/// The clock that another node publishes on /clock, received by whoever serves the queue of the
/// handle.
class ClockFollower {
 public:
  explicit ClockFollower(ros::NodeHandle nh);

  bool isReceived() const { return received_; }

  /// What the clock shows; zero until it is received.
  const ros::Time& now() const { return now_; }

  /// What it showed before, at another time; zero until it has moved, and after it has gone back.
  const ros::Time& before() const { return before_; }

  /// Whether the clock has gone back since this was asked last.
  bool takeSetBack();

 private:
  void receive(const ClockEvent& event);

  bool received_ = false;
  bool set_back_ = false;
  ros::Time now_;
  ros::Time before_;
  ClockSources sources_;
  ros::Subscriber subscriber_;
};

}  // namespace rigid_body_sim
