#pragma once

#include <optional>
#include <string>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/scene.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/node/node_options.hpp"
#include "ros/outputs/live_markers.hpp"
#include "ros/outputs/output_topics.hpp"
#include "ros/outputs/ticker.hpp"

namespace rigid_body_sim {

/// What a run tells, on ROS or into a bag: moving bodies on /tf, <body>/odom and
/// <body>/applied_wrench, and all bodies on ~states, at the publish rate; /clock at its own; once,
/// latched: fixed bodies and named points on /tf_static, and ~markers. Without subscribers nothing
/// is computed. Stamps strictly increase.
class Outputs {
 public:
  /// The simulation, that of the scene, and the origin are watched, not copied.
  Outputs(OutputTopics topics, const NodeOptions& options, const Scene& scene,
          const Simulation& simulation, const TimeOrigin& origin);

  /// Publishes what is due at a step.
  void publishDue();

  /// Publishes the state whether due or not, unless it has been already.
  void publishNow();

  /// Sends the bodies again if viewers had come at the call before. To be called every second or
  /// so: rviz drops for good what reaches it before the frames do.
  void repeatBodies();

  /// Time has been set back to the start.
  void restart();

  /// Bodies have been moved other than by time.
  void breakTrails() { live_markers_.breakTrails(); }

 private:
  void publishOnce(const Scene& scene);
  void publishState();
  void publishClock();
  void publishMarkers();
  void publishTransforms(const ros::Time& stamp);
  void publishBody(const BodyTopics& topics, const ros::Time& stamp);

  OutputTopics topics_;
  const Simulation& simulation_;
  const TimeOrigin& origin_;
  std::string world_frame_;
  bool publish_clock_;
  Ticker state_ticker_;
  Ticker clock_ticker_;
  Ticker marker_ticker_;
  using LastStamp = std::optional<ros::Time>;  // none yet; zero is a stamp like others
  LastStamp last_state_stamp_;
  LastStamp last_clock_stamp_;
  LastStamp last_marker_stamp_;
  LiveMarkers live_markers_;
  visualization_msgs::MarkerArray bodies_;
  std::size_t viewers_ = 0;  // at the last call of repeatBodies
  bool viewers_are_new_ = false;
};

}  // namespace rigid_body_sim
