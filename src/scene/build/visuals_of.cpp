#include "scene/build/visuals_of.hpp"

#include <algorithm>
#include <cmath>

#include <rigid_body_sim/mass/principal_axes.hpp>
#include <rigid_body_sim/math/isometry.hpp>

namespace rigid_body_sim {
namespace {

Visual visualOf(const Shape& shape, const Isometry3d& X_BS) { return {shape, X_BS, {}}; }
Visual visualOf(const MeshDef& mesh, const Isometry3d& X_BS) {
  return {MeshVisual{mesh.url, mesh.scale}, X_BS, {}};
}

Visual visualOf(const SolidDef& solid, const Isometry3d& X_BS) {
  return std::visit([&](const auto& kind) { return visualOf(kind, X_BS); }, solid.geometry);
}

/// A sphere for each particle: a twentieth of the farthest one's distance from the centre of mass
/// in radius for the heaviest, volume in proportion to the mass.
std::vector<Visual> spheresOf(const Particles& particles) {
  const Vector3d center = centerOfMass(particles);
  double farthest = 0, heaviest = 0;
  for (const Particle& p : particles) {
    farthest = std::max(farthest, (p.position - center).norm());
    heaviest = std::max(heaviest, p.mass);
  }
  std::vector<Visual> spheres;
  for (const Particle& p : particles) {
    Visual& sphere = spheres.emplace_back();
    sphere.geometry = Sphere{farthest / 20 * std::cbrt(p.mass / heaviest)};
    sphere.X_BV.translation() = p.position;
  }
  return spheres;
}

/// The homogeneous box of the mass properties, given in a frame S:  I₁ = m (b² + c²)/12 and cyclic.
Visual visualOf(const MassProperties& mass, const Isometry3d& X_BS) {
  // a plate has a side of zero, which viewers do not draw
  constexpr double kThinnest = 1e-3;
  const PrincipalAxes axes = principalAxes(mass.I_Bcm);
  const Vector3d others = Vector3d::Constant(axes.I.sum()) - 2 * axes.I;
  const Vector3d sides = (6 * others / mass.mass).cwiseMax(0).cwiseSqrt();
  return {Box{sides.cwiseMax(kThinnest * sides.maxCoeff())},
          X_BS * isometry(Quaterniond(axes.R_BP), mass.com_B),
          {}};
}

Visual visualOf(const HullDef& hull, const Isometry3d& X_BS) {
  return {MeshVisual{hull.url, hull.scale}, X_BS, {}};
}

std::vector<Visual> visualsOfKind(const std::vector<CollisionDef>& solids) {
  std::vector<Visual> visuals;
  for (const CollisionDef& solid : solids) {
    const Isometry3d X_BS = isometry(solid.orientation, solid.position);
    visuals.push_back(
        std::visit([&](const auto& kind) { return visualOf(kind, X_BS); }, solid.geometry));
  }
  return visuals;
}

std::vector<Visual> visualsOfKind(const MassProperties& given) {
  return {visualOf(given, Isometry3d::Identity())};
}
std::vector<Visual> visualsOfKind(const SolidDef& solid) {
  return {visualOf(solid, Isometry3d::Identity())};
}
std::vector<Visual> visualsOfKind(const Particles& particles) { return spheresOf(particles); }
std::vector<Visual> visualsOfKind(const LinkDef& link) { return link.visuals; }
std::vector<Visual> visualsOfKind(const PlaneDef&) {
  constexpr double kSide = 20;
  constexpr Color kGrey{0.6, 0.6, 0.6, 1.0};
  return {{PatchVisual{kSide}, Isometry3d::Identity(), kGrey}};
}

std::vector<Visual> visualsOfKind(const std::vector<PartDef>& parts) {
  std::vector<Visual> visuals;
  for (const PartDef& part : parts) {
    const Isometry3d X_BS = isometry(part.orientation, part.position);
    visuals.push_back(
        std::visit([&](const auto& content) { return visualOf(content, X_BS); }, part.content));
  }
  return visuals;
}

}  // namespace

std::vector<Visual> visualsOf(const BodyDef& body) {
  std::vector<Visual> visuals;
  const bool has_solids = body.collision && !body.collision->empty();
  if (body.visual.mesh.empty() && has_solids &&
      std::holds_alternative<MassProperties>(body.composition))
    visuals = visualsOfKind(*body.collision);
  else if (body.visual.mesh.empty())
    visuals = std::visit([](const auto& kind) { return visualsOfKind(kind); }, body.composition);
  else
    visuals.push_back({MeshVisual{body.visual.mesh, body.visual.scale},
                       isometry(body.visual.orientation, body.visual.position),
                       {}});
  if (body.visual.color)
    for (Visual& visual : visuals) visual.color = body.visual.color;
  return visuals;
}

}  // namespace rigid_body_sim
