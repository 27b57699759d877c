#include "markers.hpp"

#include <filesystem>

#include "conversions.hpp"
#include "shape_markers.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

/// Markers without frame, name and colour, in the axes of the body frame.
std::vector<Marker> boxOfInertia(const Body& body) {
  // a plate has a side of zero, which rviz does not draw
  constexpr double kThinnest = 1e-3;
  const Vector3d others = Vector3d::Constant(body.I.sum()) - 2 * body.I;
  const Vector3d sides = (6 * others / body.mass).cwiseMax(0).cwiseSqrt();
  std::vector<Marker> markers = shapeMarkers(Box{sides.cwiseMax(kThinnest * sides.maxCoeff())});
  for (Marker& marker : markers) {
    marker.pose.position = toPoint(body.X_BP.translation());
    marker.pose.orientation = toQuaternion(body.q_BP);
  }
  return markers;
}

/// A URL stays as it is; a path counts from the scene file.
std::string meshUrl(const std::string& mesh, const std::string& scene_file) {
  if (mesh.find("://") != std::string::npos) return mesh;
  const std::filesystem::path directory = std::filesystem::path(scene_file).parent_path();
  return "file://" + std::filesystem::absolute(directory / mesh).lexically_normal().string();
}

std::vector<Marker> meshMarker(const std::string& url) {
  Marker marker;
  marker.type = Marker::MESH_RESOURCE;
  marker.mesh_resource = url;
  marker.scale = toVector3(Vector3d::Ones());
  marker.pose.orientation.w = 1;
  return {marker};
}

std::vector<Marker> bodyMarkers(const Scene& scene, const BodyDef& def, const Body& body) {
  if (!def.visual.mesh.empty()) return meshMarker(meshUrl(def.visual.mesh, scene.source));
  return def.shape ? shapeMarkers(*def.shape) : boxOfInertia(body);
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const Scene& scene, const World& world) {
  visualization_msgs::MarkerArray all;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::array<double, 4> color =
        scene.bodies[i].visual.color.value_or(std::array{0.35, 0.55, 0.85, 1.0});
    int id = 0;
    for (Marker& marker : bodyMarkers(scene, scene.bodies[i], world.bodies[i])) {
      marker.header.frame_id = marker.ns = world.bodies[i].name;
      marker.id = id++;
      marker.frame_locked = true;
      marker.color.r = static_cast<float>(color[0]);
      marker.color.g = static_cast<float>(color[1]);
      marker.color.b = static_cast<float>(color[2]);
      marker.color.a = static_cast<float>(color[3]);
      all.markers.push_back(marker);
    }
  }
  return all;
}

}  // namespace rigid_body_sim
