#include "scene/build/contact_shape.hpp"

#include <rigid_body_sim/math/isometry.hpp>

namespace rigid_body_sim {
namespace {

// Each adds the features of a solid whose frame S is at X_PS.

void add(const Box& box, const Isometry3d& X_PS, ContactShape& shape) {
  const Vector3d half = box.size / 2;
  for (const double x : {-half.x(), half.x()})
    for (const double y : {-half.y(), half.y()})
      for (const double z : {-half.z(), half.z()}) shape.points.push_back(X_PS * Vector3d(x, y, z));
}

void addBall(double z, double radius, const Isometry3d& X_PS, ContactShape& shape) {
  shape.balls.push_back({X_PS * Vector3d(0, 0, z), radius});
}

void addRim(double z, double radius, const Isometry3d& X_PS, ContactShape& shape) {
  shape.rims.push_back({X_PS * Vector3d(0, 0, z), X_PS.linear() * Vector3d::UnitZ(), radius});
}

void add(const Sphere& sphere, const Isometry3d& X_PS, ContactShape& shape) {
  addBall(0, sphere.radius, X_PS, shape);
}

void add(const Cylinder& cylinder, const Isometry3d& X_PS, ContactShape& shape) {
  for (const double z : {-cylinder.length / 2, cylinder.length / 2})
    addRim(z, cylinder.radius, X_PS, shape);
}

void add(const Capsule& capsule, const Isometry3d& X_PS, ContactShape& shape) {
  if (capsule.length == 0) return addBall(0, capsule.radius, X_PS, shape);
  for (const double z : {-capsule.length / 2, capsule.length / 2})
    addBall(z, capsule.radius, X_PS, shape);
}

void add(const Ellipsoid& ellipsoid, const Isometry3d& X_PS, ContactShape& shape) {
  shape.ellipsoids.push_back(
      {X_PS.translation(), Quaterniond(X_PS.linear()).normalized(), ellipsoid.semi_axes});
}

void add(const Cone& cone, const Isometry3d& X_PS, ContactShape& shape) {
  addRim(-cone.length / 4, cone.radius, X_PS, shape);
  shape.points.push_back(X_PS * Vector3d(0, 0, 0.75 * cone.length));
}

void add(const HullCorners& corners, const Isometry3d& X_PS, ContactShape& shape) {
  if (!corners) return;
  for (const Vector3d& corner : *corners) shape.points.push_back(X_PS * corner);
}

void add(const HullDef& hull, const Isometry3d& X_PS, ContactShape& shape) {
  add(hull.corners, X_PS, shape);
}

void add(const MeshDef& mesh, const Isometry3d& X_PS, ContactShape& shape) {
  add(mesh.corners, X_PS, shape);
}

void add(const MassProperties&, const Isometry3d&, ContactShape&) {}
void add(const PlaneDef&, const Isometry3d&, ContactShape&) {}

template <class... Kinds>
void add(const std::variant<Kinds...>& geometry, const Isometry3d& X_PS, ContactShape& shape) {
  std::visit([&](const auto& kind) { add(kind, X_PS, shape); }, geometry);
}

void add(const SolidDef& solid, const Isometry3d& X_PS, ContactShape& shape) {
  add(solid.geometry, X_PS, shape);
}

void add(const Particles& particles, const Isometry3d& X_PB, ContactShape& shape) {
  for (const Particle& particle : particles) shape.points.push_back(X_PB * particle.position);
}

void add(const std::vector<PartDef>& parts, const Isometry3d& X_PB, ContactShape& shape) {
  for (const PartDef& part : parts)
    std::visit(
        [&](const auto& content) {
          add(content, X_PB * isometry(part.orientation, part.position), shape);
        },
        part.content);
}

void add(const std::vector<CollisionDef>& solids, const Isometry3d& X_PB, ContactShape& shape) {
  for (const CollisionDef& solid : solids)
    add(solid.geometry, X_PB * isometry(solid.orientation, solid.position), shape);
}

void add(const LinkDef& link, const Isometry3d& X_PB, ContactShape& shape) {
  add(link.collision, X_PB, shape);
}

}  // namespace

ContactShape contactShapeOf(const BodyDef& body, const Isometry3d& X_PB) {
  ContactShape shape;
  if (body.collision)
    add(*body.collision, X_PB, shape);
  else
    std::visit([&](const auto& kind) { add(kind, X_PB, shape); }, body.composition);
  return shape;
}

}  // namespace rigid_body_sim
