#include <cmath>
#include <sstream>

#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/mass/principal_axes.hpp>
#include <rigid_body_sim/math/hat.hpp>

namespace rigid_body_sim {

Matrix3d parallelAxes(const Matrix3d& I_cm, double mass, const Vector3d& d) {
  return I_cm - mass * hat(d) * hat(d);
}

MassProperties operator+(const MassProperties& a, const MassProperties& b) {
  MassProperties sum;
  sum.mass = a.mass + b.mass;
  sum.com_B = (a.mass * a.com_B + b.mass * b.com_B) / sum.mass;
  sum.I_Bcm = parallelAxes(a.I_Bcm, a.mass, a.com_B - sum.com_B) +
              parallelAxes(b.I_Bcm, b.mass, b.com_B - sum.com_B);
  return sum;
}

MassProperties transformed(const Isometry3d& X_AB, const MassProperties& part_B) {
  const Matrix3d R_AB = X_AB.linear();
  return {part_B.mass, X_AB * part_B.com_B, R_AB * part_B.I_Bcm * R_AB.transpose()};
}

std::string massPropertiesFault(const MassProperties& m) {
  std::ostringstream fault;
  fault.precision(17);
  const Matrix3d& I = m.I_Bcm;
  if (!std::isfinite(m.mass)) {
    fault << "mass must be a finite number of kg, got " << m.mass;
  } else if (!(m.mass > 0)) {
    fault << "mass must be > 0 kg, got " << m.mass;
  } else if (!m.com_B.allFinite()) {
    fault << "center_of_mass must be finite, got [" << m.com_B.transpose() << "]";
  } else if (!I.allFinite()) {
    fault << "inertia must be finite, got [" << I.row(0) << "; " << I.row(1) << "; " << I.row(2)
          << "]";
  } else if ((I - I.transpose()).cwiseAbs().maxCoeff() > 1e-12 * I.cwiseAbs().maxCoeff()) {
    fault << "inertia must be symmetric, got [" << I.row(0) << "; " << I.row(1) << "; " << I.row(2)
          << "]";
  } else {
    const Vector3d p = principalAxes(I).I;
    if (!(p(0) > 0)) {
      fault << "inertia must be positive definite, got principal moments [" << p.transpose()
            << "] kg m^2";
    } else if (p(0) + p(1) < p(2) * (1 - 1e-9)) {
      fault << "inertia must satisfy the triangle inequality I1 + I2 >= I3, got principal moments ["
            << p.transpose() << "] kg m^2";
    }
  }
  return fault.str();
}

}  // namespace rigid_body_sim
