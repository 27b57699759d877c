#include <cmath>
#include <string>

#include "scene/limits.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

/// A vector of any length but 0, made unit.
Vector3d readDirection(const Entry& value) {
  const Vector3d v = readVector3(value, "");
  const double largest = v.cwiseAbs().maxCoeff();
  if (!(largest > 0)) value.failRule("must not be zero");
  return (v / largest).normalized();
}

double readTimeConstant(const Entry& value) {
  const double T = readNumber(value, "s");
  if (!(T >= kLeastTimeConstant && T <= kGreatestTimeConstant))
    value.failRule(std::string("must be ") + kTimeConstantRange +
                   ", or left out: then the command takes effect at once");
  return T;
}

LimitsDef readLimits(const Entry& value, const std::string& unit) {
  const std::string rule = "must be [lowest, highest] [" + unit + "]";
  const std::vector<Entry> bounds = value.items(rule);
  if (bounds.size() != 2) value.failRule(rule);
  const LimitsDef limits{readBound(bounds[0], unit), readBound(bounds[1], unit)};
  if (!(limits.lowest <= limits.highest)) value.failRule(rule + ", the lower first");
  // else no command could be held between them
  if (std::isinf(limits.lowest) && limits.lowest == limits.highest)
    value.failRule(rule + ", not both infinite alike");
  return limits;
}

/// Whether a rotor turns negatively about its direction.
bool readClockwise(const Entry& value) {
  const std::string_view text = value.node().text();
  if (text != "cw" && text != "ccw")
    value.failRule("must be cw or ccw, as seen against the direction");
  return text == "cw";
}

void readOne(const Entry& entry, ThrusterDef& thruster) {
  using Def = ThrusterDef;
  static const std::vector<Key<Def>> keys = {
      {"position", [](const Entry& e, Def& d) { d.position = readVector3(e, "m"); }},
      {"direction", [](const Entry& e, Def& d) { d.direction = readDirection(e); }},
      {"limits", [](const Entry& e, Def& d) { d.limits = readLimits(e, "N"); }},
      {"time_constant", [](const Entry& e, Def& d) { d.time_constant = readTimeConstant(e); }},
  };
  readMapping(entry, keys, thruster);
}

/// What jumps with a command cannot have inertia, nor a speed of its own at the start.
void requireTimeConstant(const Entry& entry, const RotorDef& rotor) {
  if (rotor.time_constant > 0) return;
  const YamlNode* inertia = entry.node().find("inertia");
  const YamlNode* speed = entry.node().find("speed");
  if (inertia && rotor.inertia > 0)
    entry.child(*inertia).failRule(
        "needs time_constant: without one the speed jumps with the command, and the body with it");
  if (speed)
    entry.child(*speed).failRule(
        "needs time_constant: without one the speed is always that of the command");
}

void readOne(const Entry& entry, RotorDef& rotor) {
  using Def = RotorDef;
  static const std::vector<Key<Def>> keys = {
      {"position", [](const Entry& e, Def& d) { d.position = readVector3(e, "m"); }},
      {"direction", [](const Entry& e, Def& d) { d.direction = readDirection(e); }},
      {"turns", [](const Entry& e, Def& d) { d.clockwise = readClockwise(e); }, true},
      {"thrust", [](const Entry& e, Def& d) { d.thrust = readNotNegative(e, "N s^2/rad^2"); },
       true},
      {"drag_torque",
       [](const Entry& e, Def& d) { d.drag_torque = readNotNegative(e, "N m s^2/rad^2"); }},
      {"inertia", [](const Entry& e, Def& d) { d.inertia = readNotNegative(e, "kg m^2"); }},
      {"limits", [](const Entry& e, Def& d) { d.limits = readLimits(e, "rad/s"); }},
      {"time_constant", [](const Entry& e, Def& d) { d.time_constant = readTimeConstant(e); }},
      {"speed", [](const Entry& e, Def& d) { d.speed = readNumber(e, "rad/s"); }},
  };
  readMapping(entry, keys, rotor);
  requireTimeConstant(entry, rotor);
}

void readOne(const Entry& entry, WheelDef& wheel) {
  using Def = WheelDef;
  static const std::vector<Key<Def>> keys = {
      {"axis", [](const Entry& e, Def& d) { d.axis = readDirection(e); }, true},
      {"inertia", [](const Entry& e, Def& d) { d.inertia = readPositive(e, "kg m^2"); }, true},
      {"limits", [](const Entry& e, Def& d) { d.limits = readLimits(e, "N m"); }},
      {"speed", [](const Entry& e, Def& d) { d.speed = readNumber(e, "rad/s"); }},
  };
  readMapping(entry, keys, wheel);
}

/// A mapping of names to actuators of one kind.
template <class Def>
std::vector<Def> readNamed(const Entry& entry) {
  if (entry.node().kind() != YamlNode::Kind::kMapping)
    entry.failRule("must be a mapping of names to " + entry.key());
  entry.checkCount(kMaxActuators, entry.key());
  std::vector<Def> defs;
  for (const YamlNode& node : entry.node().children()) {
    const Entry item = entry.child(node);
    Def def;
    def.name = std::string(node.key());
    def.line = node.line();
    if (!isName(def.name)) item.fail(entry.key() + ": '" + printable(def.name) + "' " + nameRule());
    readOne(item, def);
    defs.push_back(def);
  }
  return defs;
}

}  // namespace

std::vector<ThrusterDef> readThrusters(const Entry& entry) { return readNamed<ThrusterDef>(entry); }

std::vector<RotorDef> readRotors(const Entry& entry) { return readNamed<RotorDef>(entry); }

std::vector<WheelDef> readWheels(const Entry& entry) { return readNamed<WheelDef>(entry); }

CommandDef readCommand(const Entry& list_item) {
  using Def = CommandDef;
  static const std::vector<Key<Def>> keys = {
      {"body", [](const Entry& e, Def& c) { c.body = readText(e); }, true},
      {"actuator", [](const Entry& e, Def& c) { c.actuator = readText(e); }, true},
      {"value", [](const Entry& e, Def& c) { c.value = readNumber(e, "N, rad/s or N m"); }, true},
      {"start", [](const Entry& e, Def& c) { c.start = readNotNegative(e, "s"); }},
  };
  const Entry entry = list_item.as(list_item.key());
  CommandDef command;
  readMapping(entry, keys, command);
  command.line = entry.node().line();
  return command;
}

}  // namespace rigid_body_sim
