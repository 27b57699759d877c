#include <cmath>
#include <sstream>

#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/mass/principal_axes.hpp>

namespace rigid_body_sim {
namespace {

/// 17 significant digits: the figures as they were read, to the last bit.
std::ostringstream faultText() {
  std::ostringstream text;
  text.precision(17);
  return text;
}

/// Three numbers as messages write them, "1, 2, 3", where Eigen would pad them to one width.
struct Listed {
  explicit Listed(const Vector3d& v) : numbers(v) {}
  Vector3d numbers;
};

std::ostream& operator<<(std::ostream& text, const Listed& list) {
  const Vector3d& v = list.numbers;
  return text << v.x() << ", " << v.y() << ", " << v.z();
}

std::string massFault(double mass) {
  auto fault = faultText();
  if (!std::isfinite(mass))
    fault << "mass must be a finite number of kg, got " << mass;
  else if (!(mass > 0))
    fault << "mass must be > 0 kg, got " << mass;
  return fault.str();
}

std::string entriesFault(const Matrix3d& I) {
  auto fault = faultText();
  const char* rule = nullptr;
  if (!I.allFinite())
    rule = "finite";
  else if (!((I - I.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * I.cwiseAbs().maxCoeff()))
    rule = "symmetric";
  if (rule)
    fault << "inertia must be " << rule << ", got [" << Listed(I.row(0)) << "; " << Listed(I.row(1))
          << "; " << Listed(I.row(2)) << "] kg m^2";
  return fault.str();
}

std::string momentsFault(const Vector3d& p) {
  auto fault = faultText();
  if (!(p(0) > 1e-15 * p(2)))
    fault << "inertia must be positive definite, got principal moments [" << Listed(p)
          << "] kg m^2";
  else if (p(0) + p(1) < p(2) * (1 - 1e-9))
    fault << "inertia must satisfy the triangle inequality I1 + I2 >= I3, got principal moments ["
          << Listed(p) << "] kg m^2: " << p(0) + p(1) << " < " << p(2);
  return fault.str();
}

}  // namespace

std::string massPropertiesFault(const MassProperties& m) {
  std::string fault = massFault(m.mass);
  if (fault.empty() && !m.com_B.allFinite()) {
    auto text = faultText();
    text << "center_of_mass must be finite, got [" << Listed(m.com_B) << "] m";
    fault = text.str();
  }
  if (fault.empty()) fault = entriesFault(m.I_Bcm);
  if (fault.empty()) fault = momentsFault(principalAxes(m.I_Bcm).I);
  return fault;
}

}  // namespace rigid_body_sim
