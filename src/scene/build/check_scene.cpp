#include "scene/build/check_scene.hpp"

#include <map>

#include "scene/build/body_mass.hpp"
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
    throw SceneError(scene.source, body.composition_line, "body '" + body.name + "': " + fault);
}

void checkMotion(const Scene& scene, const BodyDef& body) {
  const bool moves = !body.twist.linear.isZero(0) || !body.twist.angular.isZero(0);
  if (body.fixed && moves)
    throw SceneError(scene.source, body.twist.line,
                     "body '" + body.name + "': twist must be zero, for the body is fixed, got " +
                         listed(body.twist.linear) + " m/s, " + listed(body.twist.angular) +
                         " rad/s");
}

}  // namespace

void checkScene(const Scene& scene) {
  checkNames(scene);
  for (const BodyDef& body : scene.bodies) {
    checkMassProperties(scene, body);
    checkMotion(scene, body);
  }
}

}  // namespace rigid_body_sim
