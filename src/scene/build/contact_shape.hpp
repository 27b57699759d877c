#pragma once

#include <rigid_body_sim/dynamics/contact.hpp>
#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// What a body touches by, in a frame P: its `collision`, or what it is made of. X_PB: the body
/// frame in P. Empty for given mass properties, and for a plane, which no features describe.
///   box: its corners; sphere: a ball; capsule: the balls at its ends; ellipsoid; cylinder: both
///   rims; cone: rim and apex; mesh: the corners of its hull; particles: themselves.
ContactShape contactShapeOf(const BodyDef& body, const Isometry3d& X_PB);

}  // namespace rigid_body_sim
