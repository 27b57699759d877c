#include "scene/build/check_scene.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "scene/build/body_mass.hpp"
#include "scene/build/build_actuators.hpp"
#include "scene/build/inertia_rules.hpp"
#include "scene/build/pivot_rules.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// Every frame has one name: the world's, a body's, a point's.
class FrameNames {
 public:
  explicit FrameNames(const Scene& scene) : scene_(scene) {}

  /// where: what to call the owner, put together only where the name is taken.
  template <class Where>
  void claim(const std::string& name, const char* kind, int line, const Where& where) {
    if (name == scene_.world_frame)
      throw SceneError(scene_.source, line, where() + ": '" + name + "' is the world frame's name");
    const auto [taken, is_new] = owner_of_.emplace(name, std::make_pair(kind, line));
    if (!is_new)
      throw SceneError(scene_.source, line,
                       where() + ": name is taken, by the " + taken->second.first + " on line " +
                           std::to_string(taken->second.second));
  }

 private:
  const Scene& scene_;
  std::unordered_map<std::string, std::pair<const char*, int>> owner_of_;  // its kind and line
};

void checkNames(const Scene& scene) {
  FrameNames names(scene);
  for (const BodyDef& body : scene.bodies) {
    const auto where = [&body](const std::string& part) {
      return "body '" + body.name + "'" + part;
    };
    names.claim(body.name, "body", body.line, [&] { return where(""); });
    if (frameOf(body) != body.name)
      names.claim(frameOf(body), "body", body.line, [&] { return where(": frame"); });
    for (const PointDef& point : body.points)
      names.claim(body.name + "/" + point.name, "point", point.line,
                  [&] { return where(": points." + point.name); });
    for (const ImuDef& def : body.imus)
      names.claim(body.name + "/" + def.imu.name, "IMU", def.line,
                  [&] { return where(": imus." + def.imu.name); });
  }
}

/// A half-space neither moves nor touches by another shape.
void checkPlane(const Scene& scene, const BodyDef& body) {
  const std::string where = "body '" + body.name + "': ";
  if (!body.fixed)
    throw SceneError(scene.source, body.composition_line,
                     where +
                         "shape.plane needs fixed: true, for a half-space has no mass and cannot "
                         "move");
  if (body.collision)
    throw SceneError(scene.source, body.composition_line,
                     where + "collision cannot stand beside shape.plane, which touches as it is");
}

/// where: of the body.
void checkPart(const Scene& scene, const PartDef& part, std::size_t index,
               const std::string& where) {
  const auto* given = std::get_if<MassProperties>(&part.content);
  const std::string fault = given ? partMassFault(*given) : "";
  if (!fault.empty())
    throw SceneError(scene.source, part.line,
                     where + "parts[" + std::to_string(index) + "]: " + fault);
}

void checkMassProperties(const Scene& scene, const BodyDef& body) {
  const std::string where = "body '" + body.name + "': ";
  if (const auto* parts = std::get_if<std::vector<PartDef>>(&body.composition))
    for (std::size_t i = 0; i < parts->size(); ++i) checkPart(scene, (*parts)[i], i, where);
  const std::string fault = bodyMassFault(massProperties(body));
  if (!fault.empty()) throw SceneError(scene.source, body.composition_line, where + fault);
}

void checkMotion(const Scene& scene, const BodyDef& body) {
  const bool moves = !body.twist.linear.isZero(0) || !body.twist.angular.isZero(0);
  if (body.fixed && moves)
    throw SceneError(scene.source, body.twist.line,
                     "body '" + body.name + "': twist must be zero, for the body is fixed, got " +
                         listed(body.twist.linear) + " m/s, " + listed(body.twist.angular) +
                         " rad/s");
}

/// What a medium does to a body that never moves would be said of nothing.
void checkMedium(const Scene& scene, const BodyDef& body) {
  if (!body.fixed || !(body.drag.any() || body.buoyancy)) return;
  throw SceneError(scene.source, body.buoyancy ? body.buoyancy->line : body.line,
                   "body '" + body.name + "': " + (body.buoyancy ? "buoyancy" : "drag") +
                       " cannot move the body, which is fixed; remove one of the two");
}

void checkPresence(const Scene& scene, const BodyDef& body) {
  if (body.fixed && body.absent)
    throw SceneError(scene.source, body.line,
                     "body '" + body.name +
                         "': absent cannot stand beside fixed: true, for a fixed body is always "
                         "present; remove one of the two");
}

/// Commands name an actuator by its body and its own name. A body that never moves has none.
void checkActuators(const Scene& scene, const BodyDef& body) {
  std::unordered_map<std::string, int> line_of;
  const auto check = [&](const char* key, const auto& actuators) {
    for (const auto& actuator : actuators) {
      const std::string where = "body '" + body.name + "': " + key + "." + actuator.name;
      if (body.fixed)
        throw SceneError(scene.source, actuator.line,
                         where + " cannot move its body, which is fixed");
      const auto [taken, is_new] = line_of.emplace(actuator.name, actuator.line);
      if (!is_new)
        throw SceneError(
            scene.source, actuator.line,
            where + ": name is taken, by the actuator on line " + std::to_string(taken->second));
    }
  };
  check("thrusters", body.actuators.thrusters);
  check("rotors", body.actuators.rotors);
  check("wheels", body.actuators.wheels);
  if (!body.actuators.any()) return;
  // of what a loaded scene may still break, only inertia remains
  const std::vector<WheelDef>& wheels = body.actuators.wheels;
  const std::vector<RotorDef>& rotors = body.actuators.rotors;
  const int line = !wheels.empty()   ? wheels.front().line
                   : !rotors.empty() ? rotors.front().line
                                     : body.line;
  const std::string fault = actuatorsFault(actuatorsOf(body.actuators), turningInertia(body));
  if (!fault.empty()) throw SceneError(scene.source, line, "body '" + body.name + "': " + fault);
}

/// What an IMU publishes has the name of the IMU.
void checkImus(const Scene& scene, const BodyDef& body) {
  static const std::vector<std::string> kTopics{"accel", "actuators",   "applied_wrench", "command",
                                                "odom",  "pivot_force", "wrench"};
  for (const ImuDef& def : body.imus) {
    const std::string where = "body '" + body.name + "': imus." + def.imu.name + ": ";
    if (std::find(kTopics.begin(), kTopics.end(), def.imu.name) != kTopics.end())
      throw SceneError(scene.source, def.line,
                       where + "the topic " + body.name + "/" + def.imu.name +
                           " is the body's own; an IMU needs a name other than " +
                           nameList(kTopics));
    const std::string fault = imuFault(def.imu);
    if (!fault.empty()) throw SceneError(scene.source, def.line, where + fault);
  }
}

}  // namespace

void checkScene(const Scene& scene) {
  checkNames(scene);
  for (const BodyDef& body : scene.bodies) {
    if (hasMass(body))
      checkMassProperties(scene, body);
    else
      checkPlane(scene, body);
    checkMotion(scene, body);
    checkMedium(scene, body);
    checkPresence(scene, body);
    checkPivot(scene, body);
    checkActuators(scene, body);
    checkImus(scene, body);
  }
}

}  // namespace rigid_body_sim
