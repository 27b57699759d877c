#include "support/changed_mass.hpp"

#include <variant>

namespace rigid_body_sim::test {

MassProperties propertiesOf(const Body& body) {
  const Matrix3d R = body.X_BP.linear();
  MassProperties properties{body.mass, body.X_BP.translation(),
                            R * body.I.asDiagonal() * R.transpose()};
  for (const Actuator& actuator : body.actuators)
    if (const auto* wheel = std::get_if<Wheel>(&actuator.kind))
      properties.I_Bcm += wheel->inertia * wheel->axis_B * wheel->axis_B.transpose();
  properties.I_Bcm = 0.5 * (properties.I_Bcm + properties.I_Bcm.transpose()).eval();
  return properties;
}

MassProperties loaded(const Body& body, double mass, const Vector3d& place_B, double radius) {
  const double I = 0.4 * mass * radius * radius;
  return propertiesOf(body) + MassProperties{mass, place_B, Matrix3d(I * Matrix3d::Identity())};
}

}  // namespace rigid_body_sim::test
