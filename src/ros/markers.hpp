#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// Markers of every body, each in its body's own frame, so that they follow tf and are sent once:
/// its mesh, its shape, or, where only inertia is given, the homogeneous box of the same inertia,
///   sideᵢ = √(6 (I_j + I_k − Iᵢ)/m).
visualization_msgs::MarkerArray toMarkers(const Scene& scene, const World& world);

}  // namespace rigid_body_sim
