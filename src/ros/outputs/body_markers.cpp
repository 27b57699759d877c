#include "ros/outputs/body_markers.hpp"

#include <utility>

namespace rigid_body_sim {

BodyMarkers::BodyMarkers(Topic<visualization_msgs::MarkerArray> topic,
                         visualization_msgs::MarkerArray bodies)
    : topic_(std::move(topic)), all_(std::move(bodies)) {}

void BodyMarkers::publish(const std::set<std::string>& absent, const ros::Time& stamp) {
  shown_.markers.clear();
  for (const visualization_msgs::Marker& marker : all_.markers)
    if (absent.count(marker.ns) == 0) shown_.markers.push_back(marker);
  topic_.publish(shown_, stamp);
}

visualization_msgs::MarkerArray BodyMarkers::deletions(const std::set<std::string>& bodies) const {
  visualization_msgs::MarkerArray deletions;
  for (visualization_msgs::Marker marker : all_.markers) {
    if (bodies.count(marker.ns) == 0) continue;
    marker.action = visualization_msgs::Marker::DELETE;
    deletions.markers.push_back(std::move(marker));
  }
  return deletions;
}

void BodyMarkers::repeat(const ros::Time& stamp) {
  if (viewers_are_new_) topic_.publish(shown_, stamp);
  const std::size_t viewers = topic_.subscribers();
  viewers_are_new_ = viewers > viewers_;
  viewers_ = viewers;
}

}  // namespace rigid_body_sim
