#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// The centres of central gravity, which laws are the force of on bodies that move.
std::vector<GravityCenter> gravityCentersOf(const Scene& scene);

/// The IMUs of all bodies. Throws SceneError for one on a fixed body at a centre of gravity, where
/// it is infinite.
std::vector<Imu> imusOf(const Scene& scene);

}  // namespace rigid_body_sim
