#include "scene/build/build_medium.hpp"

#include <algorithm>
#include <stdexcept>

#include <rigid_body_sim/dynamics/buoyancy.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/build/displaced_volume.hpp"

namespace rigid_body_sim {
namespace {

/// A medium at rest, alike in every direction, at the centre of mass, has a law of its own, which
/// more integrators support. It knows no point but the origin of P.
std::shared_ptr<const ForceLaw> dragOf(const Scene& scene, const DragDef& def, std::size_t body,
                                       const Body& of) {
  const bool at_origin = !def.center && (!of.pivoted || (def.linear == 0 && def.quadratic == 0));
  if (!scene.medium && at_origin && !def.hasAxes()) return std::make_shared<Drag>(body, def);
  MediumDrag::Coefficients drag;
  drag.linear = {def.linear, def.linear_axes};
  drag.quadratic = {def.quadratic, def.quadratic_axes};
  drag.angular = {def.angular, def.angular_axes};
  drag.center_P = def.center ? Vector3d(of.X_BP.inverse() * *def.center) : of.com_P;
  drag.R_PD = of.X_BP.linear().transpose();
  return std::make_shared<MediumDrag>(
      body, drag, scene.medium ? scene.medium->velocity : Vector3d(Vector3d::Zero()));
}

/// What is missing for buoyancy; empty where nothing is.
std::string buoyancyFault(const Scene& scene) {
  if (!scene.medium || scene.medium->density == 0)
    return "needs the density of the medium: add medium: {density: ..} [kg/m^3]";
  if (!scene.gravity || scene.gravity->isZero(0))
    return "needs gravity, which is uniform: add gravity: [0, 0, -9.80665]";
  const auto isCentral = [](const ForceDef& force) {
    return std::holds_alternative<CentralGravityDef>(force.law);
  };
  if (std::any_of(scene.forces.begin(), scene.forces.end(), isCentral))
    return "cannot stand beside central_gravity, for its law is that of uniform gravity";
  return "";
}

std::shared_ptr<const ForceLaw> buoyancyOf(const Scene& scene, const BodyDef& def, std::size_t body,
                                           const Body& of) {
  const auto fail = [&](const std::string& fault) {
    throw SceneError(scene.source, def.buoyancy->line,
                     "body '" + def.name + "': buoyancy " + fault);
  };
  const std::string fault = buoyancyFault(scene);
  if (!fault.empty()) fail(fault);
  DisplacedVolume displaced{0, of.X_BP * of.com_P};
  if (def.buoyancy->volume) {
    displaced.volume = *def.buoyancy->volume;
    if (def.buoyancy->center) displaced.center_B = *def.buoyancy->center;
  } else {
    const std::optional<DisplacedVolume> own = displacedVolume(def.composition);
    if (!own)
      fail(
          "must be {volume: .., center: [x, y, z]} here, for what the body is made of has no "
          "volume "
          "that the scene tells, got true");
    displaced = *own;
  }
  return std::make_shared<Buoyancy>(body, scene.medium->density * displaced.volume,
                                    of.X_BP.inverse() * displaced.center_B, *scene.gravity);
}

}  // namespace

void addMediumLaws(const Scene& scene, const std::vector<Body>& bodies, ForceLaws& laws) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDef& def = scene.bodies[i];
    if (bodies[i].fixed) continue;
    try {
      if (def.drag.any()) laws.push_back(dragOf(scene, def.drag, i, bodies[i]));
      if (def.buoyancy) laws.push_back(buoyancyOf(scene, def, i, bodies[i]));
    } catch (const std::invalid_argument& refused) {
      throw SceneError(scene.source, def.line, "body '" + def.name + "': " + refused.what());
    }
  }
}

}  // namespace rigid_body_sim
