#pragma once

#include <string>

#include <rigid_body_sim/dynamics/rotation_split.hpp>
#include <rigid_body_sim/mass/mass_properties.hpp>

namespace rigid_body_sim {

/// What never changes about a rigid body, in the principal frame P: origin at the centre of mass,
/// axes the principal axes.
struct Body {
  std::string name;
  double mass = 0;                ///< [kg] > 0
  Vector3d I;                     ///< [kg m²] principal moments, ascending
  Vector3d inv_I;                 ///< [1/(kg m²)]
  Isometry3d X_BP;                ///< P in the body frame B that the user knows
  Quaterniond q_BP;               ///< the rotation of X_BP
  RotationSplit<double> split{};  ///< of its free rotation
  bool fixed = false;             ///< never moves; its mass is then ignored
};

/// The body of the given mass properties. Throws std::invalid_argument for those that have a fault
/// (massPropertiesFault).
Body makeBody(std::string name, const MassProperties& properties_B);

}  // namespace rigid_body_sim
