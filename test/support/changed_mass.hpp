#pragma once

#include <rigid_body_sim/dynamics/body.hpp>

/// Other mass properties for the bodies of tests.
namespace rigid_body_sim::test {

/// What makeBody was given for a body without a pivot.
inline MassProperties propertiesOf(const Body& body) {
  const Matrix3d R = body.X_BP.linear();
  MassProperties properties{body.mass, body.X_BP.translation(),
                            R * body.I.asDiagonal() * R.transpose()};
  for (const Actuator& actuator : body.actuators)
    if (const auto* wheel = std::get_if<Wheel>(&actuator.kind))
      properties.I_Bcm += wheel->inertia * wheel->axis_B * wheel->axis_B.transpose();
  properties.I_Bcm = 0.5 * (properties.I_Bcm + properties.I_Bcm.transpose()).eval();
  return properties;
}

/// The same with something fixed to it: a ball, by its mass, place and radius.
inline MassProperties loaded(const Body& body, double mass, const Vector3d& place_B,
                             double radius) {
  const double I = 0.4 * mass * radius * radius;
  return propertiesOf(body) + MassProperties{mass, place_B, Matrix3d(I * Matrix3d::Identity())};
}

}  // namespace rigid_body_sim::test
