#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <visualization_msgs/InteractiveMarker.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>
#include <visualization_msgs/InteractiveMarkerUpdate.h>

#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// Offers handles to viewers by the protocol of the package interactive_markers: on
/// ~push/update_full all handles, latched; on ~push/update changes and keep-alives, each with a
/// number that counts the changes; from ~push/feedback what the viewers do. A handle that is
/// released goes back to its place on the body: the viewer has dragged it away.
///
/// That package's own server would bring a queue or thread of its own, and a timer in ROS time,
/// which stands still with a paused clock and runs for nobody. Here feedback comes from whoever
/// serves the queue of the node handle, and the rest is sent to subscribers only.
class HandleTopics {
 public:
  using Clock = std::chrono::steady_clock;
  using Feedback = visualization_msgs::InteractiveMarkerFeedback;
  using Sink = std::function<void(const Feedback&)>;

  HandleTopics(ros::NodeHandle private_nh,
               const std::vector<visualization_msgs::InteractiveMarker>& handles, const Sink& sink);

  /// Offers one more handle, or one anew; takes one back.
  void add(const visualization_msgs::InteractiveMarker& handle);
  void remove(const std::string& handle);

  /// Takes a handle back, or offers it anew, where that is not so already.
  void show(const std::string& handle, bool shown);

  /// Sends a keep-alive twice a second: without, a viewer neither starts nor goes on.
  void keepAlive(Clock::time_point now);

 private:
  void publishAll();
  void publishChange(visualization_msgs::InteractiveMarkerUpdate update);
  void putBack(const std::string& handle);

  std::map<std::string, visualization_msgs::InteractiveMarker> handles_;  // by name
  std::map<std::string, visualization_msgs::InteractiveMarker> hidden_;
  std::uint64_t changes_ = 0;
  Clock::time_point next_keep_alive_;
  Topic<visualization_msgs::InteractiveMarkerInit> all_;
  Topic<visualization_msgs::InteractiveMarkerUpdate> update_;
  ros::Subscriber feedback_;
};

}  // namespace rigid_body_sim
