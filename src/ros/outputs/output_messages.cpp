#include "ros/outputs/outputs.hpp"
#include "ros/outputs/state_messages.hpp"

/// The messages of Outputs, with the frames and covariances that its options say.
namespace rigid_body_sim {

tf2_msgs::TFMessage Outputs::toTransforms(const Snapshot& snapshot, const ros::Time& stamp) const {
  const std::vector<Body>& bodies = snapshot.world().bodies;
  const std::vector<BodyState>& states = snapshot.bodies();
  tf2_msgs::TFMessage message;
  message.transforms.reserve(moving_.size());
  for (const std::size_t i : moving_)
    message.transforms.push_back(
        toTransform(bodies[i], states[i], world_frame_, frames_.of(i), stamp));
  if (followed_ && !bodies[*followed_].absent) {
    geometry_msgs::TransformStamped target;
    target.header.stamp = stamp;
    target.header.frame_id = world_frame_;
    target.child_frame_id = frames_.named(kFollowed);
    target.transform.translation = toVector3(centerOfMass(bodies[*followed_], states[*followed_]));
    target.transform.rotation.w = 1;
    message.transforms.push_back(target);
  }
  return message;
}

nav_msgs::Odometry Outputs::toOdometry(std::size_t body, const Snapshot& snapshot,
                                       const ros::Time& stamp) const {
  nav_msgs::Odometry odometry = rigid_body_sim::toOdometry(
      snapshot.world().bodies[body], snapshot.bodies()[body], world_frame_, stamp);
  odometry.child_frame_id = frames_.of(body);
  odometry.pose.covariance = odometry.twist.covariance = covariance_;
  return odometry;
}

geometry_msgs::AccelStamped Outputs::toAcceleration(std::size_t body, const BodyMotion& motion,
                                                    const ros::Time& stamp) const {
  geometry_msgs::AccelStamped message =
      toAccelStamped(simulation_->world().bodies[body], motion, stamp);
  message.header.frame_id = frames_.of(body);
  return message;
}

geometry_msgs::WrenchStamped Outputs::toPivotForce(std::size_t body, const BodyMotion& motion,
                                                   const ros::Time& stamp) const {
  geometry_msgs::WrenchStamped message =
      rigid_body_sim::toPivotForce(simulation_->world().bodies[body], motion, stamp);
  message.header.frame_id = frames_.of(body);
  return message;
}

geometry_msgs::WrenchStamped Outputs::toWrench(std::size_t body, const Snapshot& snapshot,
                                               const ros::Time& stamp) const {
  geometry_msgs::WrenchStamped message = toWrenchStamped(
      snapshot.world().bodies[body], snapshot.bodies()[body], snapshot.appliedWrench(body), stamp);
  message.header.frame_id = frames_.of(body);
  return message;
}

sensor_msgs::JointState Outputs::toActuators(std::size_t body, const Snapshot& snapshot,
                                             const ros::Time& stamp) const {
  sensor_msgs::JointState message =
      toJointState(snapshot.world().bodies[body], snapshot.actuators(body), stamp);
  message.header.frame_id = frames_.of(body);
  return message;
}

/// All at once: bodies that act on one another share the work.
void Outputs::publishMotions(const Snapshot& snapshot, const ros::Time& stamp) {
  std::vector<const BodyTopics*> asked;
  std::vector<std::size_t> bodies;
  for (const BodyTopics& topics : topics_.bodies) {
    if (isAbsent(topics.body)) continue;
    if (!topics.acceleration.subscribers() && !topics.pivot_force.hasSubscribers()) continue;
    asked.push_back(&topics);
    bodies.push_back(topics.body);
  }
  if (asked.empty()) return;
  const std::vector<BodyMotion> motions = snapshot.motions(bodies);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (asked[k]->acceleration.subscribers())
      asked[k]->acceleration.publish(toAcceleration(bodies[k], motions[k], stamp), stamp);
    if (asked[k]->pivot_force.hasSubscribers())
      asked[k]->pivot_force.publish(toPivotForce(bodies[k], motions[k], stamp), stamp);
  }
}

}  // namespace rigid_body_sim
