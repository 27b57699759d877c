#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// Markers of a body in its own frame, so that they follow tf and are sent once: what visualsOf
/// says there is to draw.
std::vector<visualization_msgs::Marker> toMarkers(const BodyDef& body);

/// The markers of every body.
visualization_msgs::MarkerArray toMarkers(const Scene& scene);

}  // namespace rigid_body_sim
