#include "ros/outputs/markers.hpp"

#include "ros/messages/conversions.hpp"
#include "ros/outputs/shape_markers.hpp"
#include "scene/build/visuals_of.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;
using Markers = std::vector<Marker>;

Markers markersOf(const Shape& shape) { return shapeMarkers(shape); }

Markers markersOf(const MeshVisual& mesh) {
  Marker marker;
  marker.type = Marker::MESH_RESOURCE;
  marker.mesh_resource = mesh.url;
  marker.scale = toVector3(mesh.scale);
  marker.pose.orientation.w = 1;
  return {marker};
}

/// A flat box below the plane: seen from both sides, and nothing that rests on it is hidden.
Markers markersOf(const PatchVisual& patch) {
  const double thickness = 5e-4 * patch.side;
  Markers markers = shapeMarkers(Box{{patch.side, patch.side, thickness}});
  markers[0].pose.position.z = -thickness / 2;
  return markers;
}

/// From the frame of a geometry to the body frame.
void place(const Isometry3d& X_BV, Marker& marker) {
  const geometry_msgs::Quaternion& q = marker.pose.orientation;
  marker.pose.position = toPoint(X_BV * fromPoint(marker.pose.position));
  marker.pose.orientation =
      toQuaternion(Quaterniond(X_BV.linear()) * Quaterniond(q.w, q.x, q.y, q.z));
}

/// A mesh of no given colour keeps the materials of its file, if it brings any.
void paint(const std::optional<Color>& given, Marker& marker) {
  constexpr Color kBlue{0.35, 0.55, 0.85, 1.0};
  const Color color = given.value_or(kBlue);
  marker.mesh_use_embedded_materials = marker.type == Marker::MESH_RESOURCE && !given;
  marker.color.r = static_cast<float>(color[0]);
  marker.color.g = static_cast<float>(color[1]);
  marker.color.b = static_cast<float>(color[2]);
  marker.color.a = static_cast<float>(color[3]);
}

Markers markersOf(const Visual& visual) {
  Markers markers = std::visit([](const auto& g) { return markersOf(g); }, visual.geometry);
  for (Marker& marker : markers) {
    place(visual.X_BV, marker);
    paint(visual.color, marker);
  }
  return markers;
}

}  // namespace

std::vector<Marker> toMarkers(const BodyDef& body, const std::string& frame) {
  std::vector<Marker> all;
  for (const Visual& visual : visualsOf(body)) {
    for (Marker& marker : markersOf(visual)) {
      marker.header.frame_id = frame;
      marker.ns = body.name;
      marker.id = static_cast<int>(all.size());
      marker.frame_locked = true;
      all.push_back(marker);
    }
  }
  return all;
}

visualization_msgs::MarkerArray toMarkers(const Scene& scene, const TfFrames& frames) {
  visualization_msgs::MarkerArray all;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::vector<Marker> markers = toMarkers(scene.bodies[i], frames.of(i));
    all.markers.insert(all.markers.end(), markers.begin(), markers.end());
  }
  return all;
}

}  // namespace rigid_body_sim
