#include "node_driver.hpp"

#include <stdexcept>

#include <ros/callback_queue.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <rigid_body_sim/Step.h>

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

NodeDriver::NodeDriver(const std::vector<std::string>& bodies) : bodies_(bodies) {
  const auto service = [this](const std::string& name) {
    const std::string full_name = "rigid_body_node/" + name;
    ros::service::waitForService(full_name);
    return full_name;
  };
  step_ = nh_.serviceClient<Step>(service("step"), true);
  pause_ = nh_.serviceClient<std_srvs::SetBool>(service("pause"), true);
  reset_ = nh_.serviceClient<std_srvs::Trigger>(service("reset"), true);
  ros::service::waitForService("rigid_body_node/get_state");  // the fixtures ask for it at once
  constexpr std::uint32_t kQueueSize = 100000;
  for (const std::string& body : bodies_) {
    const boost::function<void(const nav_msgs::Odometry&)> receive =
        [this, body](const nav_msgs::Odometry& message) {
          const nav_msgs::Odometry before = odometry_[body];
          odometry_[body] = message;
          // while paused the standing state comes again, once a second of the wall, and so does
          // what a reset has made of it
          const bool same_time = message.header.stamp == before.header.stamp;
          const bool repeated =
              same_time && (was_reset_ || (message.pose.pose == before.pose.pose &&
                                           message.twist.twist == before.twist.twist));
          if (body != bodies_[0] || repeated) return;
          stamps_.push_back(message.header.stamp);
          was_reset_ = false;
        };
    subscribers_.push_back(nh_.subscribe<nav_msgs::Odometry>(body + "/odom", kQueueSize, receive));
  }
  const boost::function<void(const tf2_msgs::TFMessage&)> receive =
      [this](const tf2_msgs::TFMessage& message) {
        transforms_at_once_ = message.transforms.size();
        for (const auto& transform : message.transforms)
          transforms_[transform.child_frame_id] = transform;
      };
  subscribers_.push_back(nh_.subscribe<tf2_msgs::TFMessage>("/tf", kQueueSize, receive));
}

bool NodeDriver::waitFor(const std::function<bool()>& condition, double seconds) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!condition()) {
    if (!ros::ok() || ros::WallTime::now() > end) return false;
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
  return true;
}

int NodeDriver::connect() {
  for (int steps = 1; steps < 10000; ++steps) {
    Step call;
    call.request.steps = 1;
    if (!step_.call(call) || !call.response.success) break;
    if (waitFor([&] { return receivedAll(call.response.stamp); }, 0.05)) return steps;
  }
  throw std::runtime_error("the node does not step, or is not received from");
}

ros::Time NodeDriver::step(unsigned steps) {
  Step call;
  call.request.steps = steps;
  if (!step_.call(call) || !call.response.success) throw std::runtime_error("step failed");
  if (steps > 0 && !waitFor([&] { return receivedAll(call.response.stamp); }))
    throw std::runtime_error("a step was not published");
  return call.response.stamp;
}

void NodeDriver::pause(bool paused) {
  std_srvs::SetBool call;
  call.request.data = paused;
  if (!pause_.call(call) || !call.response.success) throw std::runtime_error("pause failed");
}

void NodeDriver::reset() {
  std_srvs::Trigger call;
  if (!reset_.call(call) || !call.response.success) throw std::runtime_error("reset failed");
  was_reset_ = true;
}

bool NodeDriver::receivedAll(const ros::Time& stamp) const {
  for (const std::string& body : bodies_) {
    const auto odometry = odometry_.find(body);
    const auto transform = transforms_.find(body);
    if (odometry == odometry_.end() || odometry->second.header.stamp != stamp) return false;
    if (transform == transforms_.end() || transform->second.header.stamp != stamp) return false;
  }
  return true;
}

const nav_msgs::Odometry& NodeDriver::odometry(const std::string& body) const {
  return odometry_.at(body);
}

const geometry_msgs::TransformStamped& NodeDriver::transform(const std::string& body) const {
  return transforms_.at(body);
}

Motion NodeDriver::motion(const std::string& body) const {
  const nav_msgs::Odometry& message = odometry_.at(body);
  const geometry_msgs::Quaternion& q = message.pose.pose.orientation;
  return {fromPoint(message.pose.pose.position), Quaterniond(q.w, q.x, q.y, q.z),
          fromVector3(message.twist.twist.linear), fromVector3(message.twist.twist.angular)};
}

}  // namespace rigid_body_sim
