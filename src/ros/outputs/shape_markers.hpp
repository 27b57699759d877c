#pragma once

#include <vector>

#include <visualization_msgs/Marker.h>

#include <rigid_body_sim/mass/shapes.hpp>

namespace rigid_body_sim {

/// What rviz draws for a shape, in the shape's own frame; without frame, name and colour.
std::vector<visualization_msgs::Marker> shapeMarkers(const Shape& shape);

}  // namespace rigid_body_sim
