#include "scene/build/inertia_rules.hpp"

#include <sstream>

#include <rigid_body_sim/mass/principal_axes.hpp>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// By how much I₁ + I₂ falls short of I₃; 0 unless that is the only rule broken.
double triangleGap(const MassProperties& m) {
  if (massPropertiesFault(m).empty() || !m.I_Bcm.allFinite()) return 0;
  const Vector3d I = principalAxes(m.I_Bcm).I;
  MassProperties balanced = m;
  const double gap = I[2] - I[0] - I[1];
  balanced.I_Bcm += gap * Matrix3d::Identity();
  return I[0] > 0 && gap > 0 && massPropertiesFault(balanced).empty() ? gap : 0;
}

/// fault: of m
std::string withWayOn(const std::string& fault, const MassProperties& m) {
  if (fault.empty() || triangleGap(m) == 0) return fault;
  return fault + " (impossible_inertia: balance raises the moments to meet it)";
}

}  // namespace

std::string bodyMassFault(const MassProperties& m) { return withWayOn(massPropertiesFault(m), m); }

std::string partMassFault(const MassProperties& m) {
  if (m.mass == 0 && m.I_Bcm.isZero(0)) return "";
  // A moment of zero is possible in a part. What is added to find that out is far above the
  // rounding that the rules allow for in a least moment, and below that in the inequality.
  constexpr double kExtent = 1e-12;
  MassProperties extended = m;
  const double largest = m.I_Bcm.cwiseAbs().maxCoeff();
  extended.I_Bcm += (largest > 0 ? kExtent * largest : 1) * Matrix3d::Identity();
  return massPropertiesFault(extended).empty() ? "" : bodyMassFault(m);
}

std::string balanceInertia(MassProperties& m) {
  const double gap = triangleGap(m);
  if (gap == 0) return "";
  const Vector3d before = principalAxes(m.I_Bcm).I;
  m.I_Bcm += gap * Matrix3d::Identity();
  std::ostringstream text;
  text << "principal moments " << listed(before) << " kg m^2 break I1 + I2 >= I3: raised by " << gap
       << " to " << listed(principalAxes(m.I_Bcm).I);
  return text.str();
}

}  // namespace rigid_body_sim
