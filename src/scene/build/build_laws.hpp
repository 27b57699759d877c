#pragma once

#include <rigid_body_sim/dynamics/force_law.hpp>
#include <rigid_body_sim/scene/frames.hpp>
#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// The laws of a scene between the bodies of its world. Throws SceneError for a spring that names
/// an unknown body, for one that no motion can stretch, and for contact of bodies that cannot
/// touch.
ForceLaws lawsOf(const Scene& scene, const std::vector<Body>& bodies);

}  // namespace rigid_body_sim
