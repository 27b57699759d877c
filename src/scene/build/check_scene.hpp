#pragma once

#include <rigid_body_sim/scene/scene.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {

/// Throws SceneError for what no single value of a scene shows: names taken twice, mass properties
/// that no body can have, a fixed body with a velocity, a plane that moves. A loaded scene has
/// passed this; one made by a program passes it in buildWorld.
void checkScene(const Scene& scene);

}  // namespace rigid_body_sim
