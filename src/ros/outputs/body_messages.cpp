#include "ros/outputs/body_messages.hpp"

#include <algorithm>
#include <array>

#include <rigid_body_sim/math/isometry.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {
namespace {

boost::array<double, 36> diagonalMatrix(const std::array<double, 6>& diagonal) {
  boost::array<double, 36> matrix{};
  for (std::size_t i = 0; i < 6; ++i) matrix[7 * i] = diagonal[i];
  return matrix;
}

}  // namespace

BodyMessages::BodyMessages(const Scene& scene, const NodeOptions& options)
    : world_frame_(scene.world_frame),
      frames_(scene, options.tf_prefix),
      covariance_(diagonalMatrix(options.odometry_covariance)) {
  const auto add = [this](std::size_t body, const std::string& name, const Isometry3d& X_BQ) {
    frames_on_bodies_.push_back(
        {body, toTransform(X_BQ, frames_.of(body), frames_.of(body, name), ros::Time())});
  };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (const PointDef& point : scene.bodies[i].points)
      add(i, point.name, isometry(point.orientation, point.position));
    for (const ImuDef& def : scene.bodies[i].imus)
      add(i, def.imu.name, isometry(def.imu.q_BS, def.imu.position_B));
  }
}

tf2_msgs::TFMessage BodyMessages::fixedTransforms(const Simulation& simulation,
                                                  const ros::Time& stamp) const {
  const std::vector<Body>& bodies = simulation.world().bodies;
  tf2_msgs::TFMessage message;
  auto frame = frames_on_bodies_.begin();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].fixed)
      message.transforms.push_back(
          toTransform(bodies[i], simulation.body(i), world_frame_, frames_.of(i), stamp));
    for (; frame != frames_on_bodies_.end() && frame->body == i; ++frame) {
      if (bodies[i].absent) continue;
      message.transforms.push_back(frame->transform);
      message.transforms.back().header.stamp = stamp;
    }
  }
  return message;
}

bool BodyMessages::hasFramesOn(std::size_t body) const {
  return std::any_of(frames_on_bodies_.begin(), frames_on_bodies_.end(),
                     [body](const FrameOn& frame) { return frame.body == body; });
}

tf2_msgs::TFMessage BodyMessages::transforms(const std::vector<std::size_t>& bodies,
                                             const Snapshot& snapshot,
                                             const ros::Time& stamp) const {
  const std::vector<Body>& all = snapshot.world().bodies;
  const std::vector<BodyState>& states = snapshot.bodies();
  tf2_msgs::TFMessage message;
  message.transforms.reserve(bodies.size());
  for (const std::size_t i : bodies)
    message.transforms.push_back(
        toTransform(all[i], states[i], world_frame_, frames_.of(i), stamp));
  if (followed_ && !all[*followed_].absent) {
    geometry_msgs::TransformStamped target;
    target.header.stamp = stamp;
    target.header.frame_id = world_frame_;
    target.child_frame_id = frames_.named(kFollowed);
    target.transform.translation = toVector3(centerOfMass(all[*followed_], states[*followed_]));
    target.transform.rotation.w = 1;
    message.transforms.push_back(target);
  }
  return message;
}

nav_msgs::Odometry BodyMessages::odometry(std::size_t body, const Snapshot& snapshot,
                                          const ros::Time& stamp) const {
  nav_msgs::Odometry message =
      toOdometry(snapshot.world().bodies[body], snapshot.bodies()[body], world_frame_, stamp);
  message.child_frame_id = frames_.of(body);
  message.pose.covariance = message.twist.covariance = covariance_;
  return message;
}

geometry_msgs::AccelStamped BodyMessages::acceleration(std::size_t body, const Snapshot& snapshot,
                                                       const BodyMotion& motion,
                                                       const ros::Time& stamp) const {
  geometry_msgs::AccelStamped message =
      toAccelStamped(snapshot.world().bodies[body], motion, stamp);
  message.header.frame_id = frames_.of(body);
  return message;
}

geometry_msgs::WrenchStamped BodyMessages::pivotForce(std::size_t body, const Snapshot& snapshot,
                                                      const BodyMotion& motion,
                                                      const ros::Time& stamp) const {
  geometry_msgs::WrenchStamped message = toPivotForce(snapshot.world().bodies[body], motion, stamp);
  message.header.frame_id = frames_.of(body);
  return message;
}

geometry_msgs::WrenchStamped BodyMessages::appliedWrench(std::size_t body, const Snapshot& snapshot,
                                                         const ros::Time& stamp) const {
  geometry_msgs::WrenchStamped message = toWrenchStamped(
      snapshot.world().bodies[body], snapshot.bodies()[body], snapshot.appliedWrench(body), stamp);
  message.header.frame_id = frames_.of(body);
  return message;
}

sensor_msgs::JointState BodyMessages::actuators(std::size_t body, const Snapshot& snapshot,
                                                const ros::Time& stamp) const {
  sensor_msgs::JointState message =
      toJointState(snapshot.world().bodies[body], snapshot.actuators(body), stamp);
  message.header.frame_id = frames_.of(body);
  return message;
}

}  // namespace rigid_body_sim
