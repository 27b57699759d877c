#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// Markers of every body, each in its body's own frame, so that they follow tf and are sent once:
/// what visualsOf says there is to draw.
visualization_msgs::MarkerArray toMarkers(const Scene& scene);

}  // namespace rigid_body_sim
