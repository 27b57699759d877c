#include "markers.hpp"

#include <rigid_body_sim/scene/visuals_of.hpp>

#include "conversions.hpp"
#include "shape_markers.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

constexpr Color kDefaultColor{0.35, 0.55, 0.85, 1.0};

std::vector<Marker> markersOf(const Shape& shape) { return shapeMarkers(shape); }

std::vector<Marker> markersOf(const MeshVisual& mesh) {
  Marker marker;
  marker.type = Marker::MESH_RESOURCE;
  marker.mesh_resource = mesh.url;
  marker.scale = toVector3(mesh.scale);
  marker.pose.orientation.w = 1;
  return {marker};
}

/// The marker's pose in V becomes that in B.
void place(const Isometry3d& X_BV, geometry_msgs::Pose& pose) {
  const geometry_msgs::Quaternion& q = pose.orientation;
  const Quaterniond q_BV(X_BV.linear());
  pose.position = toPoint(X_BV * fromPoint(pose.position));
  pose.orientation = toQuaternion(q_BV * Quaterniond(q.w, q.x, q.y, q.z));
}

void paint(const Color& color, std_msgs::ColorRGBA& paint) {
  paint.r = static_cast<float>(color[0]);
  paint.g = static_cast<float>(color[1]);
  paint.b = static_cast<float>(color[2]);
  paint.a = static_cast<float>(color[3]);
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const Scene& scene) {
  visualization_msgs::MarkerArray all;
  for (const BodyDef& body : scene.bodies) {
    int id = 0;
    for (const Visual& visual : visualsOf(body)) {
      const auto markers =
          std::visit([](const auto& geometry) { return markersOf(geometry); }, visual.geometry);
      for (Marker marker : markers) {
        marker.header.frame_id = marker.ns = body.name;
        marker.id = id++;
        marker.frame_locked = true;
        place(visual.X_BV, marker.pose);
        paint(visual.color.value_or(kDefaultColor), marker.color);
        all.markers.push_back(marker);
      }
    }
  }
  return all;
}

}  // namespace rigid_body_sim
