// Flies the quadrotor of config/scenes/quadrotor.yaml along a circle: odometry in, speeds of the
// rotors out. launch/drone.launch starts it; drone_pilot.py does the same in Python.

#include <cstdio>
#include <cstring>

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include "circle_pilot.hpp"

namespace {

/// [s] From a measured state to the instant at which the commands made of it take effect: the time
/// that a computer on board would need. Commands that say when keep the flight free of how long
/// messages take, as long as they come before that.
constexpr double kDelay = 0.01;

class DronePilot {
 public:
  DronePilot()
      : command_(nh_.advertise<sensor_msgs::JointState>("quadrotor/command", 10)),
        odometry_(nh_.subscribe("quadrotor/odom", 10, &DronePilot::onOdometry, this,
                                ros::TransportHints().tcpNoDelay())) {}

 private:
  static Motion motionOf(const nav_msgs::Odometry& odometry) {
    const geometry_msgs::Point& p = odometry.pose.pose.position;
    const geometry_msgs::Quaternion& q = odometry.pose.pose.orientation;
    const geometry_msgs::Vector3& v = odometry.twist.twist.linear;
    const geometry_msgs::Vector3& w = odometry.twist.twist.angular;
    return {{p.x, p.y, p.z}, {q.w, q.x, q.y, q.z}, {v.x, v.y, v.z}, {w.x, w.y, w.z}};
  }

  void onOdometry(const nav_msgs::Odometry& odometry) {
    const ros::Time now = odometry.header.stamp;
    if (start_.isZero() || now < start_) start_ = now;  // earlier: time was set back
    const PathPoint path = path_.at((now - start_).toSec());
    const std::array<double, 4> speeds = pilot_.speeds(path, motionOf(odometry));

    sensor_msgs::JointState command;
    command.header.stamp = now + ros::Duration(kDelay);
    for (const Quadrotor::Rotor& rotor : pilot_.drone.rotors) command.name.push_back(rotor.name);
    command.velocity.assign(speeds.begin(), speeds.end());
    command_.publish(command);
  }

  ros::NodeHandle nh_;
  Pilot pilot_;
  CirclePath path_;
  ros::Time start_;
  ros::Publisher command_;
  ros::Subscriber odometry_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--help") == 0) {
    std::puts(
        "usage: rosrun rigid_body_sim drone_pilot\n"
        "Flies the quadrotor of config/scenes/quadrotor.yaml along a circle: subscribes to\n"
        "quadrotor/odom, publishes quadrotor/command. Needs a ROS master, and a rigid_body_node "
        "with\n"
        "that scene, as launch/drone.launch starts it.\n\n"
        "  --help    this text");
    return 0;
  }
  try {
    ros::init(argc, argv, "drone_pilot");
  } catch (const ros::Exception& error) {  // of an argument such as __name:=9bad
    std::fprintf(stderr, "drone_pilot: %s\n", error.what());
    return 2;
  }
  DronePilot pilot;
  ros::spin();
}
