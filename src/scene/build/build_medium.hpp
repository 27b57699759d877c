#pragma once

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// Adds what the medium exerts on the bodies that move: drag and buoyancy. Throws SceneError for
/// buoyancy without a volume, a density or uniform gravity.
void addMediumLaws(const Scene& scene, const std::vector<Body>& bodies, ForceLaws& laws);

}  // namespace rigid_body_sim
