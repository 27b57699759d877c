#include "ros/mouse/handle_topics.hpp"

#include <utility>

#include <ros/this_node.h>

#include "ros/outputs/ros_transport.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerInit;
using visualization_msgs::InteractiveMarkerPose;
using visualization_msgs::InteractiveMarkerUpdate;

constexpr std::uint32_t kHandleQueue = 100;
constexpr bool kLatched = true;
constexpr std::chrono::milliseconds kKeepAlivePeriod(500);

}  // namespace

HandleTopics::HandleTopics(ros::NodeHandle private_nh,
                           const std::vector<InteractiveMarker>& handles, const Sink& sink)
    : all_(RosTransport(private_nh, kHandleQueue)
               .open<InteractiveMarkerInit>("~push/update_full", kLatched)),
      update_(RosTransport(private_nh, kHandleQueue)
                  .open<InteractiveMarkerUpdate>("~push/update", !kLatched)) {
  const boost::function<void(const Feedback&)> take = [this, sink](const Feedback& feedback) {
    sink(feedback);
    if (feedback.event_type == Feedback::MOUSE_UP) putBack(feedback.marker_name);
  };
  feedback_ = private_nh.subscribe<Feedback>("push/feedback", kHandleQueue, take);
  for (const InteractiveMarker& handle : handles) handles_[handle.name] = handle;
  publishAll();
}

void HandleTopics::add(const InteractiveMarker& handle) {
  handles_[handle.name] = handle;
  InteractiveMarkerUpdate update;
  update.markers.push_back(handle);
  publishChange(std::move(update));
}

void HandleTopics::remove(const std::string& handle) {
  if (handles_.erase(handle) == 0) return;
  InteractiveMarkerUpdate update;
  update.erases.push_back(handle);
  publishChange(std::move(update));
}

void HandleTopics::show(const std::string& handle, bool shown) {
  const auto now = handles_.find(handle);
  if (!shown && now != handles_.end()) {
    hidden_[handle] = now->second;
    return remove(handle);
  }
  const auto hidden = hidden_.find(handle);
  if (!shown || hidden == hidden_.end()) return;
  add(hidden->second);
  hidden_.erase(hidden);
}

/// Tells the viewers that are there, and those to come.
void HandleTopics::publishChange(InteractiveMarkerUpdate update) {
  update.server_id = ros::this_node::getName();
  update.seq_num = ++changes_;
  update.type = InteractiveMarkerUpdate::UPDATE;
  if (update_.hasSubscribers()) update_.publish(update, ros::Time());
  publishAll();
}

void HandleTopics::publishAll() {
  InteractiveMarkerInit all;
  all.server_id = ros::this_node::getName();
  all.seq_num = changes_;
  for (const auto& [name, handle] : handles_) all.markers.push_back(handle);
  all_.publish(all, ros::Time());
}

void HandleTopics::keepAlive(Clock::time_point now) {
  if (now < next_keep_alive_) return;
  next_keep_alive_ = now + kKeepAlivePeriod;
  if (!update_.hasSubscribers()) return;
  InteractiveMarkerUpdate update;
  update.server_id = ros::this_node::getName();
  update.seq_num = changes_;
  update.type = InteractiveMarkerUpdate::KEEP_ALIVE;
  update_.publish(update, ros::Time());
}

void HandleTopics::putBack(const std::string& handle) {
  const auto known = handles_.find(handle);
  if (known == handles_.end() || !update_.hasSubscribers()) return;
  InteractiveMarkerPose pose;
  pose.header = known->second.header;
  pose.pose = known->second.pose;
  pose.name = handle;
  InteractiveMarkerUpdate update;
  update.poses.push_back(pose);
  publishChange(std::move(update));
}

}  // namespace rigid_body_sim
