#include "ros/mouse/handle_topics.hpp"

#include <algorithm>

#include <ros/this_node.h>
#include <visualization_msgs/InteractiveMarkerInit.h>
#include <visualization_msgs/InteractiveMarkerUpdate.h>

namespace rigid_body_sim {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerInit;
using visualization_msgs::InteractiveMarkerPose;
using visualization_msgs::InteractiveMarkerUpdate;

constexpr std::uint32_t kHandleQueue = 100;
constexpr bool kLatched = true;
constexpr std::chrono::milliseconds kPeriod(500);

InteractiveMarkerUpdate numbered(std::uint64_t changes) {
  InteractiveMarkerUpdate update;
  update.server_id = ros::this_node::getName();
  update.seq_num = changes;
  return update;
}

}  // namespace

HandleTopics::HandleTopics(ros::NodeHandle private_nh,
                           const std::vector<InteractiveMarker>& handles, const Sink& sink)
    : handles_(handles),
      all_(private_nh.advertise<InteractiveMarkerInit>("push/update_full", kHandleQueue, kLatched)),
      update_(private_nh.advertise<InteractiveMarkerUpdate>("push/update", kHandleQueue)) {
  const boost::function<void(const Feedback&)> take = [this, sink](const Feedback& feedback) {
    sink(feedback);
    if (feedback.event_type == Feedback::MOUSE_UP) putBack(feedback.marker_name);
  };
  feedback_ = private_nh.subscribe<Feedback>("push/feedback", kHandleQueue, take);
  publishAll();
}

void HandleTopics::publishAll() {
  InteractiveMarkerInit all;
  all.server_id = ros::this_node::getName();
  all.seq_num = changes_;
  all.markers = handles_;
  all_.publish(all);
}

void HandleTopics::keepAlive(Clock::time_point now) {
  if (now < next_keep_alive_) return;
  next_keep_alive_ = now + kPeriod;
  if (update_.getNumSubscribers() == 0) return;
  InteractiveMarkerUpdate update = numbered(changes_);
  update.type = InteractiveMarkerUpdate::KEEP_ALIVE;
  update_.publish(update);
}

void HandleTopics::putBack(const std::string& handle) {
  const auto known =
      std::find_if(handles_.begin(), handles_.end(),
                   [&](const InteractiveMarker& marker) { return marker.name == handle; });
  if (known == handles_.end() || update_.getNumSubscribers() == 0) return;
  ++changes_;
  InteractiveMarkerUpdate update = numbered(changes_);
  update.type = InteractiveMarkerUpdate::UPDATE;
  InteractiveMarkerPose pose;
  pose.header = known->header;
  pose.pose = known->pose;
  pose.name = handle;
  update.poses.push_back(pose);
  update_.publish(update);
  publishAll();
}

}  // namespace rigid_body_sim
