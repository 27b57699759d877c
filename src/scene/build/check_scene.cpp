#include "scene/build/check_scene.hpp"

#include <cassert>
#include <map>

#include <rigid_body_sim/math/isometry.hpp>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// Every frame has one name: the world's, a body's, a point's.
void checkNames(const Scene& scene) {
  std::map<std::string, int> line_of;
  const auto claim = [&](const std::string& name, int line, const std::string& where) {
    if (name == scene.world_frame)
      throw SceneError(scene.source, line, where + ": '" + name + "' is the world frame's name");
    const auto [taken, is_new] = line_of.emplace(name, line);
    if (!is_new)
      throw SceneError(
          scene.source, line,
          where + ": name is taken, by the body on line " + std::to_string(taken->second));
  };
  for (const BodyDef& body : scene.bodies) {
    const std::string where = "body '" + body.name + "'";
    claim(body.name, body.line, where);
    for (const PointDef& point : body.points)
      claim(body.name + "/" + point.name, point.line, where + ": points." + point.name);
  }
}

void checkMassProperties(const Scene& scene, const BodyDef& body) {
  const std::string fault = massPropertiesFault(massProperties(body));
  if (!fault.empty())
    throw SceneError(scene.source, body.matter_line, "body '" + body.name + "': " + fault);
}

void checkMotion(const Scene& scene, const BodyDef& body) {
  const bool moves = !body.twist.linear.isZero(0) || !body.twist.angular.isZero(0);
  if (body.fixed && moves)
    throw SceneError(scene.source, body.twist.line,
                     "body '" + body.name + "': twist must be zero, for the body is fixed, got " +
                         listed(body.twist.linear) + " m/s, " + listed(body.twist.angular) +
                         " rad/s");
}

std::vector<MassProperties> placedParts(const std::vector<PartDef>& parts) {
  std::vector<MassProperties> placed;
  placed.reserve(parts.size());
  for (const PartDef& part : parts)
    placed.push_back(transformed(isometry(part.orientation, part.position), massProperties(part)));
  return placed;
}

}  // namespace

MassProperties massProperties(const SolidDef& solid) {
  assert((solid.shape || solid.mesh) && (solid.mass || solid.density));
  const double volume_of_it = solid.shape ? volume(*solid.shape) : solid.mesh->volume;
  const double mass = solid.mass ? *solid.mass : *solid.density * volume_of_it;
  if (solid.shape) return massProperties(*solid.shape, mass);
  return {mass, solid.mesh->unit.com_B, mass * solid.mesh->unit.I_Bcm};
}

MassProperties massProperties(const BodyDef& body) {
  if (body.link) return body.link->mass;
  if (!body.particles.empty()) return massProperties(body.particles);
  if (!body.parts.empty()) return combined(placedParts(body.parts));
  if (body.inertia) {
    assert(body.mass);
    return {*body.mass, body.center_of_mass, *body.inertia};
  }
  return massProperties(static_cast<const SolidDef&>(body));
}

void checkScene(const Scene& scene) {
  checkNames(scene);
  for (const BodyDef& body : scene.bodies) {
    checkMassProperties(scene, body);
    checkMotion(scene, body);
  }
}

}  // namespace rigid_body_sim
