#include "scene/build/body_mass.hpp"

#include <rigid_body_sim/math/isometry.hpp>

namespace rigid_body_sim {
namespace {

double volumeOfKind(const Shape& shape) { return volume(shape); }
double volumeOfKind(const MeshDef& mesh) { return mesh.volume; }

MassProperties massOf(const Shape& shape, double mass) { return massProperties(shape, mass); }
MassProperties massOf(const MeshDef& mesh, double mass) {
  return {mass, mesh.unit.com_B, mass * mesh.unit.I_Bcm};
}

MassProperties massOf(const MassProperties& given) { return given; }
MassProperties massOf(const SolidDef& solid) { return massProperties(solid); }
MassProperties massOf(const Particles& particles) { return massProperties(particles); }
MassProperties massOf(const LinkDef& link) { return link.mass; }
MassProperties massOf(const PlaneDef&) { return {}; }

MassProperties massOf(const PartDef& part) {
  return transformed(isometry(part.orientation, part.position),
                     std::visit([](const auto& content) { return massOf(content); }, part.content));
}

MassProperties massOf(const std::vector<PartDef>& parts) {
  std::vector<MassProperties> placed;
  placed.reserve(parts.size());
  for (const PartDef& part : parts) placed.push_back(massOf(part));
  return combined(placed);
}

}  // namespace

double volumeOf(const SolidGeometry& geometry) {
  return std::visit([](const auto& kind) { return volumeOfKind(kind); }, geometry);
}

MassProperties massProperties(const SolidDef& solid) {
  return std::visit([&](const auto& kind) { return massOf(kind, solid.mass); }, solid.geometry);
}

bool hasMass(const BodyDef& body) { return !std::holds_alternative<PlaneDef>(body.composition); }

MassProperties massProperties(const BodyDef& body) {
  return std::visit([](const auto& kind) { return massOf(kind); }, body.composition);
}

}  // namespace rigid_body_sim
