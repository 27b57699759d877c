#include "ros/mouse/handles.hpp"

#include "ros/messages/conversions.hpp"
#include "ros/mouse/menu.hpp"
#include "ros/outputs/arrow_markers.hpp"
#include "ros/outputs/markers.hpp"
#include "ros/outputs/shape_markers.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;

/// So that the mouse finds the shell, not the body within.
constexpr double kLarger = 1.02;

constexpr float kOpacity = 0.3F;

/// Draws a marker, at a pose in the body frame, as a part of the shell about the centre of mass c:
/// x becomes c + s (x − c).
Marker shellOf(Marker marker, const Vector3d& com_B) {
  const Vector3d x_B = fromPoint(marker.pose.position);
  marker.header.frame_id.clear();  // that of the handle
  marker.frame_locked = false;
  marker.pose.position = toPoint(com_B + kLarger * (x_B - com_B));
  marker.scale = toVector3(kLarger * fromVector3(marker.scale));
  marker.mesh_use_embedded_materials = false;
  marker.color.a = kOpacity;
  return marker;
}

/// For a body of which nothing is drawn.
std::vector<Marker> ballOf(const Body& body) {
  std::vector<Marker> ball = shapeMarkers(Sphere{sizeOf(body) / 2});
  for (Marker& marker : ball) marker.pose.position = toPoint(body.X_BP * body.com_P);
  return ball;
}

}  // namespace

InteractiveMarker toHandle(const BodyDef& def, const Body& body, const std::string& frame) {
  InteractiveMarkerControl control;
  control.name = "push";
  control.orientation.w = 1;
  control.orientation_mode = InteractiveMarkerControl::VIEW_FACING;
  control.independent_marker_orientation = true;
  control.interaction_mode = InteractiveMarkerControl::MOVE_PLANE;
  std::vector<Marker> markers = toMarkers(def, frame);
  for (const Marker& marker : markers.empty() ? ballOf(body) : markers)
    control.markers.push_back(shellOf(marker, body.X_BP * body.com_P));

  InteractiveMarker handle;
  handle.header.frame_id = frame;
  handle.name = body.name;
  handle.pose.orientation.w = 1;
  handle.scale = static_cast<float>(sizeOf(body));
  handle.controls.push_back(control);
  handle.menu_entries = menuEntries();
  return handle;
}

std::vector<InteractiveMarker> toHandles(const Scene& scene, const World& world,
                                         const TfFrames& frames) {
  std::vector<InteractiveMarker> handles;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!world.bodies[i].fixed)
      handles.push_back(toHandle(scene.bodies[i], world.bodies[i], frames.of(i)));
  }
  return handles;
}

}  // namespace rigid_body_sim
