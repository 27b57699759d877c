#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <tf2_ros/transform_listener.h>

#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/usage.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/node/command_line.hpp"

using namespace rigid_body_sim;

namespace {

const char* const kHelp = R"(usage: rosrun rigid_body_sim demo_pusher
Client of demo.launch: subscribes to box/odom and publishes box/wrench, by which it keeps the box
swinging. Needs a ROS master, and a rigid_body_node with config/scenes/demo.yaml.

  --help    this text
)";

/// Client of the demo: for a part of every period it pushes the box, which hangs on a spring, at
/// one of its corners, so that it goes round below the place where the spring is fixed. The corner
/// is the one where the push spins the box up while it turns slowly, and down while it turns fast.
class DemoPusher {
 public:
  DemoPusher()
      : listener_(buffer_),
        wrench_(nh_.advertise<geometry_msgs::WrenchStamped>("box/wrench", 10)),
        odometry_(nh_.subscribe("box/odom", 10, &DemoPusher::onOdometry, this)) {}

 private:
  // pushes that begin and end often enough to be watched, with time between them to swing freely
  static constexpr double kPeriod = 1.5;  // [s]
  static constexpr double kPush = 0.5;    // [s] of each period
  // of a push, per error of velocity [N s/m]: at 1 m/s a fifth of the weight of the box, so that it
  // is kept going and not led
  static constexpr double kGain = 4.0;
  // [rad/s] above it pushes slow the spin: a turn in 2.5 s can still be followed by the eye
  static constexpr double kLiveliest = 2.5;
  // Where the box hangs at rest: the spring, fixed at 3.4 m, is 1.4 m + m g / k = 1.73 m long.
  static constexpr double kHeight = 1.67;  // [m]
  // The radius of the round [m]: the box, 0.34 m from its centre to a corner, stays clear of the
  // quadrotor on its circle of 1.5 m. The speed is that of a pendulum as long as the spring,
  // r sqrt(g / 1.73 m).
  static constexpr double kRadius = 0.4;
  static constexpr double kSpeed = 0.95;  // [m/s]
  static constexpr double kPull = 1.0;    // [1/s] back to the round, per distance from it
  static constexpr double kLeast = 1e-3;  // [m] from the axis: nearer no direction is outward

  struct Corner {
    std::string frame;
    Vector3d position_B;  // [m]
    Quaterniond q_BF;
  };

  /// The velocity [m/s] at which the box would go its round from here.
  static Vector3d wantedVelocity(const Vector3d& x_W) {
    const Vector3d radial(x_W.x(), x_W.y(), 0);
    const Vector3d outward = radial / std::max(radial.norm(), kLeast);
    const Vector3d to_round =
        (kRadius - radial.norm()) * outward + (kHeight - x_W.z()) * Vector3d::UnitZ();
    return kSpeed * Vector3d::UnitZ().cross(outward) + kPull * to_round;
  }

  void onOdometry(const nav_msgs::Odometry& odometry) {
    if (!findCorners(odometry.child_frame_id)) return;
    const bool pushing = std::fmod(odometry.header.stamp.toSec(), kPeriod) < kPush;
    const geometry_msgs::Quaternion& q = odometry.pose.pose.orientation;
    const Quaterniond q_WB(q.w, q.x, q.y, q.z);
    const Vector3d v_B = fromVector3(odometry.twist.twist.linear);
    const Vector3d x_W = fromPoint(odometry.pose.pose.position);
    const Vector3d force_B = kGain * (q_WB.conjugate() * wantedVelocity(x_W) - v_B);
    if (pushing && !was_pushing_)
      corner_ = chooseCorner(force_B, fromVector3(odometry.twist.twist.angular));
    if (pushing) push(odometry.header.stamp, force_B);
    if (!pushing && was_pushing_) push(odometry.header.stamp, Vector3d::Zero());
    was_pushing_ = pushing;
  }

  /// Looks the corners up once; false while tf does not know them.
  bool findCorners(const std::string& body) {
    if (!corners_[0].frame.empty()) return true;
    std::array<Corner, 4> found;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::string frame = body + "/corner_" + std::to_string(i + 1);
      if (!buffer_.canTransform(body, frame, ros::Time())) return false;
      const geometry_msgs::Transform X =
          buffer_.lookupTransform(body, frame, ros::Time()).transform;
      const geometry_msgs::Quaternion& q = X.rotation;
      found[i] = {frame, fromVector3(X.translation), Quaterniond(q.w, q.x, q.y, q.z)};
    }
    corners_ = found;
    return true;
  }

  std::size_t chooseCorner(const Vector3d& force_B, const Vector3d& w_B) const {
    const double sign = w_B.norm() < kLiveliest ? 1 : -1;
    const auto spinUp = [&](std::size_t i) {
      return sign * corners_[i].position_B.cross(force_B).dot(w_B);
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      if (spinUp(i) > spinUp(best)) best = i;
    }
    return best;
  }

  void push(const ros::Time& stamp, const Vector3d& force_B) {
    geometry_msgs::WrenchStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = corners_[corner_].frame;
    message.wrench.force = toVector3(corners_[corner_].q_BF.conjugate() * force_B);
    wrench_.publish(message);
  }

  ros::NodeHandle nh_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  std::array<Corner, 4> corners_;
  std::size_t corner_ = 0;
  bool was_pushing_ = false;
  ros::Publisher wrench_;
  ros::Subscriber odometry_;
};

}  // namespace

int main(int argc, char** argv) {
  reserveStandardStreams();
  failBeyondFileSize();
  if (asksForHelp(argc, argv)) return printHelp("demo_pusher", kHelp);
  if (!initRos(argc, argv, "demo_pusher")) return kWrongUsage;
  DemoPusher pusher;
  ros::spin();
  return kDone;
}
