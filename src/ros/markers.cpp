#include "markers.hpp"

#include <cmath>

#include "conversions.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

void setShape(const Box& box, Marker& marker) {
  marker.type = Marker::CUBE;
  marker.scale = toVector3(box.size);
}

void setShape(const Sphere& sphere, Marker& marker) {
  marker.type = Marker::SPHERE;
  marker.scale = toVector3(Vector3d::Constant(2 * sphere.radius));
}

void setShape(const Cylinder& cylinder, Marker& marker) {
  marker.type = Marker::CYLINDER;
  marker.scale = toVector3({2 * cylinder.radius, 2 * cylinder.radius, cylinder.length});
}

void setBoxOfInertia(const Body& body, Marker& marker) {
  // a plate has a side of zero, which rviz does not draw
  constexpr double kThinnest = 1e-3;
  const Vector3d others = Vector3d::Constant(body.I.sum()) - 2 * body.I;
  const Vector3d sides = (6 * others / body.mass).cwiseMax(0).cwiseSqrt();
  setShape(Box{sides.cwiseMax(kThinnest * sides.maxCoeff())}, marker);
  marker.pose.position = toPoint(body.X_BP.translation());
  marker.pose.orientation = toQuaternion(body.q_BP);
}

Marker toMarker(const BodyDef& def, const Body& body) {
  Marker marker;
  marker.header.frame_id = body.name;
  marker.ns = body.name;
  marker.frame_locked = true;
  marker.pose.orientation.w = 1;
  const std::array<double, 4> color = def.visual.color.value_or(std::array{0.35, 0.55, 0.85, 1.0});
  marker.color.r = static_cast<float>(color[0]);
  marker.color.g = static_cast<float>(color[1]);
  marker.color.b = static_cast<float>(color[2]);
  marker.color.a = static_cast<float>(color[3]);
  if (!def.visual.mesh.empty()) {
    marker.type = Marker::MESH_RESOURCE;
    marker.mesh_resource = def.visual.mesh;
    marker.scale = toVector3(Vector3d::Ones());
  } else if (def.shape) {
    std::visit([&marker](const auto& shape) { setShape(shape, marker); }, *def.shape);
  } else {
    setBoxOfInertia(body, marker);
  }
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const Scene& scene, const World& world) {
  visualization_msgs::MarkerArray markers;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    markers.markers.push_back(toMarker(scene.bodies[i], world.bodies[i]));
  return markers;
}

}  // namespace rigid_body_sim
