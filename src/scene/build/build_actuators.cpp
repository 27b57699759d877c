#include "scene/build/build_actuators.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/build/body_names.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

Thruster made(const ThrusterDef& def) { return {def.position, def.direction, def.time_constant}; }

Rotor made(const RotorDef& def) {
  return {def.position,    def.direction, def.clockwise ? -1 : 1, def.thrust,
          def.drag_torque, def.inertia,   def.time_constant,      def.speed};
}

Wheel made(const WheelDef& def) { return {def.axis, def.inertia, def.speed}; }

template <class Def>
void append(const std::vector<Def>& defs, std::vector<Actuator>& actuators) {
  for (const Def& def : defs)
    actuators.push_back({def.name, made(def), def.limits.lowest, def.limits.highest});
}

[[noreturn]] void refuseUnknown(const std::string& what, const std::string& name,
                                const std::string& of, const std::vector<std::string>& known) {
  throw std::invalid_argument(
      "unknown " + what + " '" + printable(name) + "'" + of +
      (known.empty() ? ", which has none" : " (known: " + nameList(known) + ")") +
      didYouMean(name, known));
}

}  // namespace

std::vector<Actuator> actuatorsOf(const ActuatorDefs& defs) {
  std::vector<Actuator> actuators;
  append(defs.thrusters, actuators);
  append(defs.rotors, actuators);
  append(defs.wheels, actuators);
  return actuators;
}

std::size_t actuatorNamed(const std::string& name, const Body& body) {
  const auto found = std::find_if(body.actuators.begin(), body.actuators.end(),
                                  [&](const Actuator& actuator) { return actuator.name == name; });
  if (found != body.actuators.end())
    return static_cast<std::size_t>(found - body.actuators.begin());
  std::vector<std::string> names;
  for (const Actuator& actuator : body.actuators) names.push_back(actuator.name);
  refuseUnknown("actuator", name, " of body '" + body.name + "'", names);
}

std::vector<ActuatorCommand> commandsOf(const Scene& scene, const std::vector<Body>& bodies) {
  if (scene.commands.empty()) return {};
  std::unordered_map<std::string, std::size_t> index_of;
  for (std::size_t i = 0; i < bodies.size(); ++i) index_of.emplace(bodies[i].name, i);
  std::vector<ActuatorCommand> commands;
  for (const CommandDef& def : scene.commands) {
    try {
      const auto body = index_of.find(def.body);
      if (body == index_of.end()) refuseUnknown("body", def.body, "", namesOf(bodies));
      if (bodies[body->second].absent)
        throw std::invalid_argument("body '" + def.body +
                                    "' is absent, and starts without commands");
      const std::size_t actuator = actuatorNamed(def.actuator, bodies[body->second]);
      commands.push_back({body->second, actuator, def.value, def.start});
    } catch (const std::invalid_argument& refused) {
      throw SceneError(scene.source, def.line,
                       "commands[" + std::to_string(commands.size()) + "]: " + refused.what());
    }
  }
  return commands;
}

}  // namespace rigid_body_sim
