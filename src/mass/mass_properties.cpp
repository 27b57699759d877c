#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/mass/particles.hpp>

#include "math/compensated_sum.hpp"

namespace rigid_body_sim {

Matrix3d parallelAxes(const Matrix3d& I_cm, double mass, const Vector3d& d) {
  return I_cm + pointInertia(mass, d);
}

MassProperties combined(const std::vector<MassProperties>& parts) {
  CompensatedSum<double> mass(0);
  CompensatedSum<Vector3d> mass_com(Vector3d::Zero());
  for (const MassProperties& part : parts) {
    mass.add(part.mass);
    mass_com.add(part.mass * part.com_B);
  }
  MassProperties whole;
  whole.mass = mass.value();
  if (whole.mass != 0) whole.com_B = mass_com.value() / whole.mass;

  CompensatedSum<Matrix3d> I(Matrix3d::Zero());
  for (const MassProperties& part : parts)
    I.add(parallelAxes(part.I_Bcm, part.mass, part.com_B - whole.com_B));
  whole.I_Bcm = I.value();
  return whole;
}

MassProperties operator+(const MassProperties& a, const MassProperties& b) {
  return combined({a, b});
}

MassProperties transformed(const Isometry3d& X_AB, const MassProperties& part_B) {
  const Matrix3d R_AB = X_AB.linear();
  const Matrix3d I_A = R_AB * part_B.I_Bcm * R_AB.transpose();
  return {part_B.mass, X_AB * part_B.com_B, (I_A + I_A.transpose()) / 2};
}

}  // namespace rigid_body_sim
