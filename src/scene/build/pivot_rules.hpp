#pragma once

#include <optional>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// [m] The point on which a body is held; none: it moves freely.
std::optional<Vector3d> pivotOf(const BodyDef& body);

/// [kg m²] The inertia that turns: about the centre of mass or the pivot, in body axes, wheels and
/// rotors included.
Matrix3d turningInertia(const BodyDef& body);

/// Throws SceneError for a pivot that breaks a rule. The body's mass properties break none.
void checkPivot(const Scene& scene, const BodyDef& body);

}  // namespace rigid_body_sim
