#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

/// A simulation time that has no stamp; what() is one line.
class BeyondRosTime : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where simulation time zero lies in ROS time. Whole nanoseconds on both sides: a double of
/// seconds since 1970 is good to 2e-7 s only.
struct TimeOrigin {
  ros::Time start;

  /// Whether simulation time t [s] has a stamp: ROS time ends 2^32 s after its start, in 2106.
  bool hasStamp(double t) const;

  /// Stamp of simulation time t [s]. Throws BeyondRosTime.
  ros::Time stamp(double t) const;
  /// Simulation time [s] of a stamp; negative before the start.
  double simulationTime(const ros::Time& stamp) const;
};

/// Exact number of seconds of a duration, rounded once.
double toSeconds(const ros::Duration& duration);

geometry_msgs::Point toPoint(const Vector3d& v);
geometry_msgs::Vector3 toVector3(const Vector3d& v);
geometry_msgs::Quaternion toQuaternion(const Quaterniond& q);
Vector3d fromPoint(const geometry_msgs::Point& p);
Vector3d fromVector3(const geometry_msgs::Vector3& v);

/// Pose of the body frame B in the world.
geometry_msgs::Pose toPose(const BodyFrameMotion& motion);

/// Twist of the body frame B against the world, in body axes, at the origin o of B:
///   ω_B = R_BP I⁻¹ L_P,   v_o = R_WBᵀ p/m − ω_B × com_B.
geometry_msgs::Twist toTwistInBodyAxes(const Body& body, const BodyState& state);

/// Pose as toPose, twist as toTwistInBodyAxes; covariances zero: the state is exact.
nav_msgs::Odometry toOdometry(const Body& body, const BodyState& state,
                              const std::string& world_frame, const ros::Time& stamp);

/// The body frame in the world.
geometry_msgs::TransformStamped toTransform(const Body& body, const BodyState& state,
                                            const std::string& world_frame,
                                            const std::string& body_frame, const ros::Time& stamp);

/// The frame `child` at pose X in the frame `parent`.
geometry_msgs::TransformStamped toTransform(const Isometry3d& X, const std::string& parent,
                                            const std::string& child, const ros::Time& stamp);

}  // namespace rigid_body_sim
