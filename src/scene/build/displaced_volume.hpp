#pragma once

#include <optional>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// A volume and its centroid.
struct DisplacedVolume {
  double volume = 0;                     ///< [m³]
  Vector3d center_B = Vector3d::Zero();  ///< [m] in the body frame
};

/// Of what a body is made of: its shape or mesh, or the sum of its parts, Σ V_i c_i/Σ V_i. Nothing
/// where that, or a part, has none.
std::optional<DisplacedVolume> displacedVolume(const CompositionDef& composition);

}  // namespace rigid_body_sim
