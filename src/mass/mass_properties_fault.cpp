#include <cmath>

#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/mass/principal_axes.hpp>

#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

/// "1, 2, 3"
std::string listed(const Vector3d& v) {
  return shortest(v.x()) + ", " + shortest(v.y()) + ", " + shortest(v.z());
}

std::string massFault(double mass) {
  if (!std::isfinite(mass)) return "mass must be a finite number of kg, got " + shortest(mass);
  if (!(mass > 0)) return "mass must be > 0 kg, got " + shortest(mass);
  if (!std::isfinite(1 / mass))
    return "mass must be so large that 1/mass is a finite number, got " + shortest(mass) + " kg";
  return "";
}

std::string entriesFault(const Matrix3d& I) {
  const char* rule = nullptr;
  if (!I.allFinite())
    rule = "finite";
  else if (!((I - I.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * I.cwiseAbs().maxCoeff()))
    rule = "symmetric";
  if (!rule) return "";
  return std::string("inertia must be ") + rule + ", got [" + listed(I.row(0)) + "; " +
         listed(I.row(1)) + "; " + listed(I.row(2)) + "] kg m^2";
}

std::string momentsFault(const Vector3d& p) {
  if (!(p(0) > 1e-15 * p(2)))
    return "inertia must be positive definite, got principal moments [" + listed(p) + "] kg m^2";
  if (!std::isfinite(1 / p(0)))
    return "inertia must be so large that its inverse is finite, got principal moments [" +
           listed(p) + "] kg m^2";
  if (p(0) + p(1) < p(2) * (1 - 1e-9))
    return "inertia must satisfy the triangle inequality I1 + I2 >= I3, got principal moments [" +
           listed(p) + "] kg m^2: " + shortest(p(0) + p(1)) + " < " + shortest(p(2));
  return "";
}

}  // namespace

std::string massPropertiesFault(const MassProperties& m) {
  std::string fault = massFault(m.mass);
  if (fault.empty() && !m.com_B.allFinite())
    fault = "center_of_mass must be finite, got [" + listed(m.com_B) + "] m";
  if (fault.empty()) fault = entriesFault(m.I_Bcm);
  if (fault.empty()) fault = momentsFault(principalAxes(m.I_Bcm).I);
  return fault;
}

}  // namespace rigid_body_sim
