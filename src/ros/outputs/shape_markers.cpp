#include "ros/outputs/shape_markers.hpp"

#include <cmath>

#include "math/wide.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;
using Markers = std::vector<Marker>;

Marker scaled(int type, const Vector3d& scale) {
  Marker marker;
  marker.type = type;
  marker.scale = toVector3(scale);
  marker.pose.orientation.w = 1;
  return marker;
}

Markers markersOf(const Box& box) { return {scaled(Marker::CUBE, box.size)}; }

Markers markersOf(const Sphere& sphere) {
  return {scaled(Marker::SPHERE, Vector3d::Constant(2 * sphere.radius))};
}

Markers markersOf(const Ellipsoid& ellipsoid) {
  return {scaled(Marker::SPHERE, 2 * ellipsoid.semi_axes)};
}

Markers markersOf(const Cylinder& c) {
  return {scaled(Marker::CYLINDER, {2 * c.radius, 2 * c.radius, c.length})};
}

/// A cylinder and two whole spheres, of which half shows.
Markers markersOf(const Capsule& capsule) {
  const Marker ball = scaled(Marker::SPHERE, Vector3d::Constant(2 * capsule.radius));
  Markers markers(2, ball);
  markers[0].pose.position.z = -capsule.length / 2;
  markers[1].pose.position.z = capsule.length / 2;
  if (capsule.length > 0) markers.push_back(markersOf(Cylinder{capsule.radius, capsule.length})[0]);
  return markers;
}

/// Triangles, since rviz has no cone of its own.
Markers markersOf(const Cone& cone) {
  constexpr int kSides = 48;
  const Vector3d apex(0, 0, 0.75 * cone.length);
  const Vector3d middle(0, 0, -0.25 * cone.length);
  const auto rim = [&](int k) {
    const double angle = 2 * kPi<double> * k / kSides;
    return Vector3d(middle + cone.radius * Vector3d(std::cos(angle), std::sin(angle), 0));
  };
  Marker marker = scaled(Marker::TRIANGLE_LIST, Vector3d::Ones());
  for (int k = 0; k < kSides; ++k) {
    for (const Vector3d& corner : {apex, rim(k), rim(k + 1), middle, rim(k + 1), rim(k)})
      marker.points.push_back(toPoint(corner));
  }
  return {marker};
}

}  // namespace

Markers shapeMarkers(const Shape& shape) {
  return std::visit([](const auto& s) { return markersOf(s); }, shape);
}

}  // namespace rigid_body_sim
