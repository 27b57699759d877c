#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

namespace rigid_body_sim {
namespace {

/// Loads a node with wrenches at a rate, sent to its bodies in turn, and measures what comes of it:
/// the rate of the odometry, how evenly it comes, and how long a wrench takes to be seen in it.
///
/// The first body is probed by a force along z that changes its sign. A node that simulates shows
/// it by a velocity that no longer changes by the same amount from message to message; one that
/// echoes, by a velocity that changes at all.
class NodeLoad {
 public:
  NodeLoad(int bodies, double wrench_rate, double seconds)
      : wrench_rate_(wrench_rate), seconds_(seconds) {
    for (int i = 1; i <= bodies; ++i) {
      const std::string name = "body" + std::to_string(i);
      wrenches_.push_back(nh_.advertise<geometry_msgs::WrenchStamped>(name + "/wrench", 1000));
      const boost::function<void(const nav_msgs::Odometry&)> receive =
          [this, i](const nav_msgs::Odometry& message) { take(i == 1, message); };
      odometry_.push_back(nh_.subscribe<nav_msgs::Odometry>(
          name + "/odom", 1000, receive, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
    }
  }

  bool connect() {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(20);
    while (ros::ok() && ros::WallTime::now() < end) {
      if (std::all_of(wrenches_.begin(), wrenches_.end(),
                      [](const ros::Publisher& p) { return p.getNumSubscribers() > 0; }) &&
          std::all_of(odometry_.begin(), odometry_.end(),
                      [](const ros::Subscriber& s) { return s.getNumPublishers() > 0; }))
        return true;
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    }
    return false;
  }

  void run() {
    const double begin = now();
    double next_probe = begin + 1;  // after what the start stirs up
    long long sent = 0;
    measuring_from_ = begin + 1;
    while (ros::ok() && now() < begin + seconds_) {
      const auto due = static_cast<long long>((now() - begin) * wrench_rate_);
      for (; sent < due; ++sent) push(static_cast<std::size_t>(sent) % wrenches_.size());
      if (!probe_is_out_ && is_steady_ && now() > next_probe) {
        probe();
        // at any time between two messages, not just after one
        next_probe =
            now() + std::uniform_real_distribution<double>(kLeastPause, kMaxPause)(random_);
      }
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.0001));
    }
    elapsed_ = now() - measuring_from_;
    sent_rate_ = static_cast<double>(sent) / (now() - begin);
  }

  void print(const char* what) {
    std::printf("%-28s %8.0f %9.0f", what, sent_rate_, static_cast<double>(received_) / elapsed_);
    for (std::vector<double>* sample : {&latency_, &interval_})
      std::printf(" %9.3f %9.3f", 1e3 * quantile(*sample, 0.5), 1e3 * quantile(*sample, 0.999));
    std::printf("\n");
  }

 private:
  static double now() { return ros::WallTime::now().toSec(); }

  /// About z, which leaves the axis of the probes alone.
  void push(std::size_t body) {
    geometry_msgs::WrenchStamped message;
    message.header.frame_id = "body" + std::to_string(body + 1);
    message.wrench.torque.z = 0.01;
    wrenches_[body].publish(message);
  }

  /// The first body, along z of the world.
  void probe() {
    geometry_msgs::WrenchStamped message;
    message.header.frame_id = "world";
    message.wrench.force.z = force_ = -force_;
    probe_is_out_ = true;
    probed_at_ = now();
    wrenches_[0].publish(message);
  }

  void take(bool is_first, const nav_msgs::Odometry& message) {
    const double t = now();
    if (t < measuring_from_) return;
    ++received_;
    if (!is_first) return;
    if (last_received_ > 0) interval_.push_back(t - last_received_);
    last_received_ = t;
    const double change = message.twist.twist.linear.z - last_velocity_;
    is_steady_ = std::abs(change - last_change_) < kRounding;
    last_velocity_ += change;
    last_change_ = change;
    if (is_steady_ || !probe_is_out_) return;
    latency_.push_back(t - probed_at_);
    probe_is_out_ = false;
  }

  static double quantile(std::vector<double>& sample, double q) {
    if (sample.empty()) return std::nan("");
    std::sort(sample.begin(), sample.end());
    return sample[static_cast<std::size_t>(q * static_cast<double>(sample.size() - 1))];
  }

  double wrench_rate_, seconds_;
  ros::NodeHandle nh_;
  std::vector<ros::Publisher> wrenches_;
  std::vector<ros::Subscriber> odometry_;
  static constexpr double kRounding = 1e-9;                        // [m/s] of velocities below 1
  static constexpr double kLeastPause = 0.025, kMaxPause = 0.035;  // [s] two messages at 100 Hz

  std::mt19937 random_{1};
  double force_ = -1;  // [N] of the last probe
  bool is_steady_ = false, probe_is_out_ = false;
  double probed_at_ = 0, last_velocity_ = 0, last_change_ = 0, last_received_ = 0;
  double measuring_from_ = std::numeric_limits<double>::infinity();
  double elapsed_ = 0, sent_rate_ = 0;
  long long received_ = 0;
  std::vector<double> latency_, interval_;  // [s]
};

/// The floor: what roscpp alone takes. Publishes odometry at a rate, its velocity the last force
/// along z, and does nothing else.
void echo(int bodies, double rate) {
  ros::NodeHandle nh;
  ros::CallbackQueue queue;
  nh.setCallbackQueue(&queue);
  std::vector<ros::Publisher> publishers;
  std::vector<ros::Subscriber> subscribers;
  nav_msgs::Odometry odometry;
  const boost::function<void(const geometry_msgs::WrenchStamped&)> receive =
      [&](const geometry_msgs::WrenchStamped& message) {
        if (message.header.frame_id == "world")
          odometry.twist.twist.linear.z = message.wrench.force.z;
      };
  for (int i = 1; i <= bodies; ++i) {
    const std::string name = "body" + std::to_string(i);
    publishers.push_back(nh.advertise<nav_msgs::Odometry>(name + "/odom", 100));
    subscribers.push_back(nh.subscribe<geometry_msgs::WrenchStamped>(
        name + "/wrench", 1000, receive, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  }
  const ros::WallTime begin = ros::WallTime::now();
  for (long long tick = 1; ros::ok(); ++tick) {
    const double due = static_cast<double>(tick) / rate;
    for (double wait; (wait = due - (ros::WallTime::now() - begin).toSec()) > 0;)
      queue.callAvailable(ros::WallDuration(std::min(wait, 0.05)));
    for (const ros::Publisher& publisher : publishers) publisher.publish(odometry);
  }
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  ros::init(argc, argv, "node_load", ros::init_options::AnonymousName);
  if (argc == 4 && std::string(argv[1]) == "echo") {
    echo(std::atoi(argv[2]), std::atof(argv[3]));
    return 0;
  }
  if (argc != 5) {
    std::fprintf(stderr,
                 "usage: node_load NAME BODIES WRENCHES_PER_SECOND SECONDS\n"
                 "       node_load echo BODIES RATE\n");
    return 2;
  }
  NodeLoad load(std::atoi(argv[2]), std::atof(argv[3]), std::atof(argv[4]));
  if (!load.connect()) {
    std::fprintf(stderr, "node_load: no node is there\n");
    return 1;
  }
  load.run();
  load.print(argv[1]);
  return 0;
}
