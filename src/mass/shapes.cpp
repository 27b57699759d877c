#include <rigid_body_sim/mass/shapes.hpp>

namespace rigid_body_sim {
namespace {

constexpr double kPi = 3.14159265358979323846;

double volumeOf(const Box& box) { return box.size.prod(); }
double volumeOf(const Sphere& s) { return 4.0 / 3.0 * kPi * s.radius * s.radius * s.radius; }
double volumeOf(const Cylinder& c) { return kPi * c.radius * c.radius * c.length; }

Vector3d momentsOf(const Box& box, double m) {
  const Vector3d s2 = box.size.cwiseAbs2();
  return m / 12 * Vector3d(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y());
}
Vector3d momentsOf(const Sphere& s, double m) {
  return Vector3d::Constant(2.0 / 5.0 * m * s.radius * s.radius);
}
Vector3d momentsOf(const Cylinder& c, double m) {
  const double r2 = c.radius * c.radius;
  const double across = m / 12 * (3 * r2 + c.length * c.length);
  return {across, across, m / 2 * r2};
}

}  // namespace

double volume(const Shape& shape) {
  return std::visit([](const auto& s) { return volumeOf(s); }, shape);
}

MassProperties massProperties(const Shape& shape, double mass) {
  const Vector3d I = std::visit([mass](const auto& s) { return momentsOf(s, mass); }, shape);
  return {mass, Vector3d::Zero(), I.asDiagonal()};
}

}  // namespace rigid_body_sim
