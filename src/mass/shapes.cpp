#include <cmath>
#include <stdexcept>

#include <rigid_body_sim/mass/shapes.hpp>

#include "math/wide.hpp"

namespace rigid_body_sim {
namespace {

double volumeOf(const Box& box) { return box.size.prod(); }
double volumeOf(const Sphere& s) {
  return 4.0 / 3.0 * kPi<double> * s.radius * s.radius * s.radius;
}
double volumeOf(const Cylinder& c) { return kPi<double> * c.radius * c.radius * c.length; }
double volumeOf(const Capsule& c) {
  return kPi<double> * c.radius * c.radius * (c.length + 4.0 / 3.0 * c.radius);
}
double volumeOf(const Ellipsoid& e) { return 4.0 / 3.0 * kPi<double> * e.semi_axes.prod(); }
double volumeOf(const Cone& c) { return kPi<double> / 3.0 * c.radius * c.radius * c.length; }

Vector3d momentsOf(const Box& box, double m) {
  const Vector3d s2 = box.size.cwiseAbs2();
  return m / 12 * Vector3d(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y());
}
Vector3d momentsOf(const Ellipsoid& e, double m) {
  const Vector3d s2 = e.semi_axes.cwiseAbs2();
  return m / 5 * Vector3d(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y());
}
Vector3d momentsOf(const Sphere& s, double m) {
  return Vector3d::Constant(2.0 / 5.0 * m * s.radius * s.radius);
}
Vector3d momentsOf(const Cylinder& c, double m) {
  const double r2 = c.radius * c.radius;
  const double across = m / 12 * (3 * r2 + c.length * c.length);
  return {across, across, m / 2 * r2};
}
Vector3d momentsOf(const Capsule& c, double m) {
  const double r = c.radius, l = c.length;
  const double m_cylinder = m * l / (l + 4.0 / 3.0 * r);
  const double m_caps = m * 4 * r / (3 * l + 4 * r);
  const double across = m_cylinder * (3 * r * r + l * l) / 12 +
                        m_caps * (2.0 / 5.0 * r * r + 3.0 / 8.0 * r * l + l * l / 4);
  return {across, across, (m_cylinder / 2 + 2.0 / 5.0 * m_caps) * r * r};
}
Vector3d momentsOf(const Cone& c, double m) {
  const double r2 = c.radius * c.radius;
  const double across = 3.0 / 80.0 * m * (4 * r2 + c.length * c.length);
  return {across, across, 3.0 / 10.0 * m * r2};
}

bool isLength(double x) { return x > 0 && std::isfinite(x); }
bool areLengths(const Vector3d& v) { return isLength(v.x()) && isLength(v.y()) && isLength(v.z()); }

bool isPossible(const Box& box) { return areLengths(box.size); }
bool isPossible(const Ellipsoid& e) { return areLengths(e.semi_axes); }
bool isPossible(const Sphere& s) { return isLength(s.radius); }
bool isPossible(const Capsule& c) {
  return isLength(c.radius) && (c.length == 0 || isLength(c.length));
}
template <class Round>
bool isPossible(const Round& shape) {
  return isLength(shape.radius) && isLength(shape.length);
}

}  // namespace

double volume(const Shape& shape) {
  return std::visit([](const auto& s) { return volumeOf(s); }, shape);
}

MassProperties massProperties(const Shape& shape, double mass) {
  if (!std::visit([](const auto& s) { return isPossible(s); }, shape))
    throw std::invalid_argument(
        "lengths of a shape must be > 0 m, of a capsule between its caps >= 0, and finite");
  const Vector3d I = std::visit([mass](const auto& s) { return momentsOf(s, mass); }, shape);
  return {mass, Vector3d::Zero(), I.asDiagonal()};
}

}  // namespace rigid_body_sim
