#pragma once

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// [m³]
double volumeOf(const SolidGeometry& geometry);

/// Mass properties of a solid, in the frame of its geometry.
MassProperties massProperties(const SolidDef& solid);

/// Whether it has mass properties; a plane has none.
bool hasMass(const BodyDef& body);

/// Mass properties of a body, in the body frame; zero where it has none.
MassProperties massProperties(const BodyDef& body);

}  // namespace rigid_body_sim
