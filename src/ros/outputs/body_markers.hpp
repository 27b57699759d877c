#pragma once

#include <set>
#include <string>

#include <visualization_msgs/MarkerArray.h>

#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// The markers of the bodies themselves, latched on ~markers: of those that are present.
class BodyMarkers {
 public:
  /// bodies: of the whole scene; the namespace of a marker is the name of its body.
  BodyMarkers(Topic<visualization_msgs::MarkerArray> topic, visualization_msgs::MarkerArray bodies);

  /// Publishes those of the bodies that are present.
  void publish(const std::set<std::string>& absent, const ros::Time& stamp);

  /// Deletions of the markers of these bodies.
  visualization_msgs::MarkerArray deletions(const std::set<std::string>& bodies) const;

  /// Publishes again if viewers had come at the call before. To be called every second or so: rviz
  /// drops for good what reaches it before the frames do.
  void repeat(const ros::Time& stamp);

 private:
  Topic<visualization_msgs::MarkerArray> topic_;
  visualization_msgs::MarkerArray all_;
  visualization_msgs::MarkerArray shown_;
  std::size_t viewers_ = 0;  // at the last call of repeat
  bool viewers_are_new_ = false;
};

}  // namespace rigid_body_sim
