#include "scene/build/visuals_of.hpp"

#include <algorithm>
#include <cmath>

#include <rigid_body_sim/mass/principal_axes.hpp>
#include <rigid_body_sim/math/isometry.hpp>

#include "scene/build/check_scene.hpp"

namespace rigid_body_sim {
namespace {

Visual visualOf(const SolidDef& solid, const Isometry3d& X_BS) {
  if (solid.shape) return {*solid.shape, X_BS, {}};
  return {MeshVisual{solid.mesh->url, Vector3d::Constant(solid.mesh->scale)}, X_BS, {}};
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
  for (const Particle& p : particles)
    spheres.push_back({Sphere{farthest / 20 * std::cbrt(p.mass / heaviest)},
                       isometry(Quaterniond::Identity(), p.position),
                       {}});
  return spheres;
}

/// The homogeneous box of the given mass properties:  I₁ = m (b² + c²)/12 and cyclic.
Visual boxOf(const MassProperties& mass) {
  // a plate has a side of zero, which viewers do not draw
  constexpr double kThinnest = 1e-3;
  const PrincipalAxes axes = principalAxes(mass.I_Bcm);
  const Vector3d others = Vector3d::Constant(axes.I.sum()) - 2 * axes.I;
  const Vector3d sides = (6 * others / mass.mass).cwiseMax(0).cwiseSqrt();
  return {Box{sides.cwiseMax(kThinnest * sides.maxCoeff())},
          isometry(Quaterniond(axes.R_BP), mass.com_B),
          {}};
}

std::vector<Visual> visualsOfMatter(const BodyDef& body) {
  if (body.link) return body.link->visuals;
  if (!body.particles.empty()) return spheresOf(body.particles);
  if (body.inertia) return {boxOf(massProperties(body))};
  if (body.parts.empty()) return {visualOf(body, Isometry3d::Identity())};
  std::vector<Visual> visuals;
  for (const PartDef& part : body.parts)
    visuals.push_back(visualOf(part, isometry(part.orientation, part.position)));
  return visuals;
}

}  // namespace

std::vector<Visual> visualsOf(const BodyDef& body) {
  std::vector<Visual> visuals;
  if (body.visual.mesh.empty())
    visuals = visualsOfMatter(body);
  else
    visuals.push_back({MeshVisual{body.visual.mesh, Vector3d::Ones()}, Isometry3d::Identity(), {}});
  if (body.visual.color)
    for (Visual& visual : visuals) visual.color = body.visual.color;
  return visuals;
}

}  // namespace rigid_body_sim
