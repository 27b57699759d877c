#include <chrono>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <rigid_body_sim/AppliedWrench.h>

namespace rigid_body_sim {
namespace {

/// Publishes wrenches at full speed, most of them with something that no node can take, none that
/// could make a simulation diverge; and receives what the node makes of it. Ends with 1 when the
/// node has been silent for that long [s].
class Garbage {
 public:
  static constexpr double kLongestSilence = 20;

  Garbage()
      : general_(nh_.advertise<AppliedWrench>("rigid_body_node/wrench", 1000)),
        everyday_(nh_.advertise<geometry_msgs::WrenchStamped>("box/wrench", 1000)),
        odometry_(nh_.subscribe("box/odom", 1000, &Garbage::receive, this)) {}

  int run() {
    Clock::time_point next_report = Clock::now();
    while (ros::ok()) {
      for (int i = 0; i < 100; ++i) publishOne();
      ros::getGlobalCallbackQueue()->callAvailable();
      const Clock::time_point now = Clock::now();
      if (now - last_received_ > std::chrono::duration<double>(kLongestSilence)) {
        std::printf("no odometry for %.0f s\n", kLongestSilence);
        return 1;
      }
      if (now < next_report) continue;
      next_report = now + std::chrono::seconds(10);
      std::printf("sent %lld, odometry received %lld\n", sent_, received_);
      std::fflush(stdout);
    }
    return 0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void receive(const nav_msgs::Odometry&) {
    ++received_;
    last_received_ = Clock::now();
  }

  void publishOne() {
    ++sent_;
    AppliedWrench message;
    message.header.frame_id = name();
    message.body = name();
    message.id = name();
    message.point_frame = name();
    message.point.x = number();
    message.wrench.force.y = number();
    message.wrench.torque.z = number();
    message.start = ros::Time::now() + ros::Duration(0.01 * static_cast<double>(random_() % 300));
    message.duration = ros::Duration(static_cast<int>(random_() % 5) - 2, 0);
    if (random_() % 2 == 0) {
      general_.publish(message);
    } else {
      geometry_msgs::WrenchStamped everyday;
      everyday.header = message.header;
      everyday.wrench = message.wrench;
      everyday_.publish(everyday);
    }
  }

  /// What the scene knows, nothing, or any bytes.
  std::string name() {
    switch (random_() % 8) {
      case 0:
        return "";
      case 1: {
        std::string bytes(random_() % 1000, ' ');
        for (char& byte : bytes) byte = static_cast<char>(random_());
        return bytes;
      }
      case 2:
        return "world";
      default:
        return "box";
    }
  }

  double number() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kNumbers[] = {0, 0.1, -0.1, 5e-324, kInfinity, -kInfinity};
    const std::size_t i = random_() % 8;
    return i < 6 ? kNumbers[i] : std::numeric_limits<double>::quiet_NaN();
  }

  std::mt19937 random_{1};
  long long sent_ = 0, received_ = 0;
  Clock::time_point last_received_ = Clock::now();
  ros::NodeHandle nh_;
  ros::Publisher general_;
  ros::Publisher everyday_;
  ros::Subscriber odometry_;
};

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  ros::init(argc, argv, "garbage");
  return rigid_body_sim::Garbage().run();
}
