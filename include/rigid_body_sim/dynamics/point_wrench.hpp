#pragma once

#include <cstddef>
#include <limits>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Stands for the world where the index of a body may stand.
constexpr std::size_t kWorld = std::numeric_limits<std::size_t>::max();

/// Stands for the body acted on where the index of a body may stand.
constexpr std::size_t kOwnBody = kWorld - 1;

/// A constant force and couple applied at a point of a body for a stretch of simulation time.
/// Axes and point may each be fixed in the world or in any body, and turn with it.
struct PointWrench {
  std::size_t body = 0;       ///< the body acted on
  std::size_t axes = kWorld;  ///< of force and torque: world axes or a body's principal axes
  Vector3d force = Vector3d::Zero();   ///< [N] at the point
  Vector3d torque = Vector3d::Zero();  ///< [N m] a free couple
  std::size_t point_frame = kOwnBody;  ///< of point: world frame or a body's principal frame
  Vector3d point = Vector3d::Zero();   ///< [m]
  bool at_center = false;  ///< point is Body::com_P of the body acted on, and goes along with it
  /// [s] Acts for start <= t < end, and not at all where end <= start. Of an input (WrenchInput) a
  /// start that is past means now, and the end is later by as much.
  double start = 0;
  double end = std::numeric_limits<double>::infinity();
};

}  // namespace rigid_body_sim
