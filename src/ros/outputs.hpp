#pragma once

#include <string>
#include <vector>

#include <ros/node_handle.h>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

#include "conversions.hpp"
#include "node_options.hpp"
#include "ticker.hpp"

namespace rigid_body_sim {

/// What the node tells: moving bodies on /tf and <body>/odom at the publish rate, /clock at its
/// own; once, latched: fixed bodies and named points on /tf_static, and ~markers. Without
/// subscribers nothing is computed. Stamps strictly increase.
class Outputs {
 public:
  Outputs(ros::NodeHandle nh, ros::NodeHandle private_nh, const NodeOptions& options,
          const Scene& scene, const World& world, const State& initial, const TimeOrigin& origin);

  /// Publishes what is due at a step.
  void publishDue(const State& state);

  /// Publishes the state whether due or not, unless it has been already.
  void publishNow(const State& state);

  /// Time has been set back to the start.
  void restart();

 private:
  struct Odometer {
    std::size_t body;
    ros::Publisher publisher;
  };

  void publishOnce(const Scene& scene, const State& initial);
  void publishState(const State& state);
  void publishClock(const State& state);
  void publishTransforms(const State& state, const ros::Time& stamp);

  const World& world_;
  std::string world_frame_;
  TimeOrigin origin_;
  bool publish_clock_;
  Ticker state_ticker_;
  Ticker clock_ticker_;
  ros::Time last_state_stamp_;
  ros::Time last_clock_stamp_;
  ros::Publisher tf_;
  ros::Publisher tf_static_;
  ros::Publisher markers_;
  ros::Publisher clock_;
  std::vector<Odometer> odometers_;  // of the bodies that move
};

}  // namespace rigid_body_sim
