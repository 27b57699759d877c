#pragma once

#include <optional>
#include <vector>

#include <visualization_msgs/Marker.h>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// The way that a body has come lately, as line strips that viewers keep: each point is sent with
/// the strip that it belongs to only, and a strip takes the place of the oldest one.
class Trail {
 public:
  static constexpr const char* kNamespace = "motion/trail";
  static constexpr int kStrips = 10;
  static constexpr int kPointsPerStrip = 30;

  /// first_id: its markers have the kStrips ids from there on. width [m].
  Trail(int first_id, double width) : first_id_(first_id), width_(width) {}

  /// Goes on to a point [m]. Returns the strip that changed, in the world and without header; none
  /// for the first point of all.
  std::optional<visualization_msgs::Marker> add(const Vector3d& x_W);

  /// The next point is not joined to the last.
  void breakOff();

 private:
  int first_id_;
  double width_;
  int strip_ = 0;
  std::vector<Vector3d> points_;  // of the current strip
};

}  // namespace rigid_body_sim
