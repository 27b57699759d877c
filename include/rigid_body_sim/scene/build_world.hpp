#pragma once

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {

/// What stays constant of a scene. Throws SceneError for one that breaks a rule of doc/scene.md, as
/// one without bodies or with a name twice does; for a wrench or a spring that names an unknown
/// body or frame or acts on fixed bodies only; and for an integrator that is unknown or does not
/// support what acts in the scene.
World buildWorld(const Scene& scene);

/// The state at time zero; world: that of the scene.
State initialState(const Scene& scene, const World& world);

}  // namespace rigid_body_sim
