#pragma once

#include <optional>
#include <string>
#include <vector>

#include <boost/array.hpp>
#include <geometry_msgs/AccelStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/scene.hpp>

#include "ros/messages/tf_frames.hpp"
#include "ros/options/node_options.hpp"
#include "ros/outputs/snapshot.hpp"

namespace rigid_body_sim {

/// The messages of single bodies and of tf, in the frames and with the covariances that the options
/// of the node ask for.
class BodyMessages {
 public:
  BodyMessages(const Scene& scene, const NodeOptions& options);

  const std::string& worldFrame() const { return world_frame_; }
  const TfFrames& frames() const { return frames_; }

  /// From now on the frame kFollowed on /tf is where the centre of mass of a body is, its axes
  /// those of the world: a camera that has it as its target does not turn with the body. It stays
  /// where it is when nothing is followed any more.
  static constexpr const char* kFollowed = "followed_body";
  void follow(std::optional<std::size_t> body) { followed_ = body; }

  /// Of fixed bodies, and of named points and IMUs on bodies that are present; for /tf_static.
  tf2_msgs::TFMessage fixedTransforms(const Simulation& simulation, const ros::Time& stamp) const;

  /// Whether points or IMUs of a body are on /tf_static while it is present.
  bool hasFramesOn(std::size_t body) const;

  /// Of these bodies, and of what is followed.
  tf2_msgs::TFMessage transforms(const std::vector<std::size_t>& bodies, const Snapshot& snapshot,
                                 const ros::Time& stamp) const;

  nav_msgs::Odometry odometry(std::size_t body, const Snapshot& snapshot,
                              const ros::Time& stamp) const;
  /// motion: of that body.
  geometry_msgs::AccelStamped acceleration(std::size_t body, const Snapshot& snapshot,
                                           const BodyMotion& motion, const ros::Time& stamp) const;
  geometry_msgs::WrenchStamped pivotForce(std::size_t body, const Snapshot& snapshot,
                                          const BodyMotion& motion, const ros::Time& stamp) const;
  geometry_msgs::WrenchStamped appliedWrench(std::size_t body, const Snapshot& snapshot,
                                             const ros::Time& stamp) const;
  sensor_msgs::JointState actuators(std::size_t body, const Snapshot& snapshot,
                                    const ros::Time& stamp) const;

 private:
  std::string world_frame_;
  TfFrames frames_;
  struct FrameOn {
    std::size_t body;
    geometry_msgs::TransformStamped transform;
  };
  std::vector<FrameOn> frames_on_bodies_;  // named points and IMUs, body by body
  boost::array<double, 36> covariance_;    // of pose and twist
  std::optional<std::size_t> followed_;    // by cameras
};

}  // namespace rigid_body_sim
