#include "ros/messages/conversions.hpp"

#include <cmath>
#include <sstream>

namespace rigid_body_sim {
namespace {

std::int64_t nanoseconds(const ros::Time& stamp) {
  return static_cast<std::int64_t>(stamp.sec) * 1000000000 + stamp.nsec;
}

/// A message with the fields x, y and z.
template <class Message>
Message xyz(const Vector3d& v) {
  Message message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

geometry_msgs::TransformStamped stamped(const std::string& parent, const std::string& child,
                                        const ros::Time& stamp) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stamp;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  return transform;
}

}  // namespace

bool TimeOrigin::hasStamp(double t) const {
  constexpr double kEnd = 4294967296.0;  // [s] 2^32
  return t < kEnd && t + start.toSec() < kEnd - 1;
}

ros::Time TimeOrigin::stamp(double t) const {
  if (!hasStamp(t)) {
    std::ostringstream line;
    line << "simulation time " << t << " s has no stamp: ROS time ends in 2106, 2^32 s after its "
         << "start, and this run began at " << start << " s";
    throw BeyondRosTime(line.str());
  }
  ros::Time stamp;
  const double seconds = std::floor(t);  // apart, as their nanoseconds would round
  stamp.fromNSec(static_cast<std::uint64_t>(nanoseconds(start) +
                                            static_cast<std::int64_t>(seconds) * 1000000000 +
                                            std::llround((t - seconds) * 1e9)));
  return stamp;
}

double TimeOrigin::simulationTime(const ros::Time& stamp) const {
  return static_cast<double>(nanoseconds(stamp) - nanoseconds(start)) / 1e9;
}

double toSeconds(const ros::Duration& duration) {
  return static_cast<double>(duration.toNSec()) / 1e9;
}

geometry_msgs::Point toPoint(const Vector3d& v) { return xyz<geometry_msgs::Point>(v); }

geometry_msgs::Vector3 toVector3(const Vector3d& v) { return xyz<geometry_msgs::Vector3>(v); }

geometry_msgs::Quaternion toQuaternion(const Quaterniond& q) {
  geometry_msgs::Quaternion u;
  u.x = q.x();
  u.y = q.y();
  u.z = q.z();
  u.w = q.w();
  return u;
}

Vector3d fromPoint(const geometry_msgs::Point& p) { return {p.x, p.y, p.z}; }

Vector3d fromVector3(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

geometry_msgs::Pose toPose(const BodyFrameMotion& motion) {
  geometry_msgs::Pose pose;
  pose.position = toPoint(motion.x_W);
  pose.orientation = toQuaternion(motion.q_WB);
  return pose;
}

geometry_msgs::Twist toTwistInBodyAxes(const Body& body, const BodyState& state) {
  const Vector3d w_B = rotate(body.q_BP, angularVelocity(body.inv_I, state.L_P));
  const Vector3d v_P = rotateBack(state.q_WP, Vector3d(state.p_W / body.mass));
  const Vector3d com_B = body.X_BP.translation();
  geometry_msgs::Twist twist;
  twist.linear = toVector3(rotate(body.q_BP, v_P) - w_B.cross(com_B));
  twist.angular = toVector3(w_B);
  return twist;
}

nav_msgs::Odometry toOdometry(const Body& body, const BodyState& state,
                              const std::string& world_frame, const ros::Time& stamp) {
  nav_msgs::Odometry odometry;
  odometry.header.stamp = stamp;
  odometry.header.frame_id = world_frame;
  odometry.child_frame_id = body.name;
  odometry.pose.pose = toPose(toBodyFrameMotion(body, state));
  odometry.twist.twist = toTwistInBodyAxes(body, state);
  return odometry;
}

geometry_msgs::TransformStamped toTransform(const Body& body, const BodyState& state,
                                            const std::string& world_frame,
                                            const std::string& body_frame, const ros::Time& stamp) {
  const BodyFrameMotion motion = toBodyFrameMotion(body, state);
  geometry_msgs::TransformStamped transform = stamped(world_frame, body_frame, stamp);
  transform.transform.translation = toVector3(motion.x_W);
  transform.transform.rotation = toQuaternion(motion.q_WB);
  return transform;
}

geometry_msgs::TransformStamped toTransform(const Isometry3d& X, const std::string& parent,
                                            const std::string& child, const ros::Time& stamp) {
  geometry_msgs::TransformStamped transform = stamped(parent, child, stamp);
  transform.transform.translation = toVector3(X.translation());
  transform.transform.rotation = toQuaternion(Quaterniond(X.linear()));
  return transform;
}

}  // namespace rigid_body_sim
