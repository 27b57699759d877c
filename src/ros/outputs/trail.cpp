#include "ros/outputs/trail.hpp"

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

using visualization_msgs::Marker;

std::optional<Marker> Trail::add(const Vector3d& x_W) {
  if (points_.size() > kPointsPerStrip) {
    const Vector3d joint = points_.back();
    breakOff();
    points_.push_back(joint);
  }
  points_.push_back(x_W);
  if (points_.size() < 2) return {};

  Marker marker;
  marker.type = Marker::LINE_STRIP;
  marker.ns = kNamespace;
  marker.id = first_id_ + strip_;
  marker.pose.orientation.w = 1;
  marker.scale.x = width_;
  marker.color.r = marker.color.g = marker.color.b = 0.9F;
  marker.color.a = 0.7F;
  for (const Vector3d& point : points_) marker.points.push_back(toPoint(point));
  return marker;
}

void Trail::breakOff() {
  // a lone point has not been sent: its strip is still free
  if (points_.size() > 1) strip_ = (strip_ + 1) % kStrips;
  points_.clear();
}

}  // namespace rigid_body_sim
