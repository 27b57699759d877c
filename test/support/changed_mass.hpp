#pragma once

#include <rigid_body_sim/dynamics/body.hpp>

/// Other mass properties for the bodies of tests.
namespace rigid_body_sim::test {

/// What makeBody was given for a body without a pivot.
MassProperties propertiesOf(const Body& body);

/// The same with something fixed to it: a ball, by its mass, place and radius.
MassProperties loaded(const Body& body, double mass, const Vector3d& place_B, double radius);

}  // namespace rigid_body_sim::test
