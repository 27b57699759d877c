#include "scene/state/read_state_body.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "dynamics/world_changes.hpp"
#include "math/shortest.hpp"
#include "scene/files/percent_code.hpp"
#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

template <class Def>
using Keys = std::vector<Key<Def>>;

/// With the bits that it has: not normalised.
Quaterniond readAttitude(const Entry& value) {
  const std::vector<double> q = readNumbers(value, 4, "");
  return {q[3], q[0], q[1], q[2]};
}

/// Adds the keys of a body's state to others; state(def): where it belongs.
template <class Def, BodyState& (*state)(Def&)>
Keys<Def> withState(Keys<Def> keys) {
  const Keys<Def> of_state = {
      {"position", [](const Entry& e, Def& d) { state(d).x_W = readVector3(e, "m"); }, true},
      {"position_low", [](const Entry& e, Def& d) { state(d).x_low_W = readVector3(e, "m"); },
       true},
      {"attitude", [](const Entry& e, Def& d) { state(d).q_WP = readAttitude(e); }, true},
      {"momentum", [](const Entry& e, Def& d) { state(d).p_W = readVector3(e, "kg m/s"); }, true},
      {"angular_momentum_world",
       [](const Entry& e, Def& d) { state(d).L_W = readVector3(e, "kg m^2/s"); }, true},
      {"angular_momentum_body",
       [](const Entry& e, Def& d) { state(d).L_P = readVector3(e, "kg m^2/s"); }, true},
  };
  keys.insert(keys.end(), of_state.begin(), of_state.end());
  return keys;
}

BodyState& stateOf(MotionAnchor& anchor) { return anchor.state; }

MotionAnchor readAnchor(const Entry& value) {
  static const Keys<MotionAnchor> keys = withState<MotionAnchor, stateOf>({
      {"time", [](const Entry& e, MotionAnchor& a) { a.t = readNumber(e, "s"); }, true},
      {"horizon", [](const Entry& e, MotionAnchor& a) { a.horizon = readBound(e, "s"); }, true},
  });
  MotionAnchor anchor;
  readMapping(value, keys, anchor);
  return anchor;
}

std::string readSlot(const Entry& value) {
  const std::optional<std::string> slot = percentDecoded(readTextOrNone(value));
  if (!slot) value.failRule("must have two hexadecimal digits after each %");
  return *slot;
}

/// A value that belongs to a body of a world.
template <class T>
struct OfBody {
  const BodyIndex& index;
  const Body& body;
  T value;
};

std::size_t readActuatorName(const Entry& value, const Body& body) {
  const std::string name = readName(value);
  for (std::size_t k = 0; k < body.actuators.size(); ++k)
    if (body.actuators[k].name == name) return k;
  value.failRule("must be an actuator of the body");
}

ScheduledWrench readEntry(const Entry& item, const BodyIndex& index, const Body& body) {
  using Wrench = OfBody<ScheduledWrench>;
  static const Keys<Wrench> keys = {
      {"slot", [](const Entry& e, Wrench& w) { w.value.slot = readSlot(e); }, true},
      {"axes", [](const Entry& e, Wrench& w) { w.value.wrench.axes = readBodyName(e, w.index); }},
      {"point_frame",
       [](const Entry& e, Wrench& w) { w.value.wrench.point_frame = readBodyName(e, w.index); }},
      {"force", [](const Entry& e, Wrench& w) { w.value.wrench.force = readVector3(e, "N"); },
       true},
      {"torque", [](const Entry& e, Wrench& w) { w.value.wrench.torque = readVector3(e, "N m"); },
       true},
      {"point", [](const Entry& e, Wrench& w) { w.value.wrench.point = readVector3(e, "m"); },
       true},
      {"at_center_of_mass",
       [](const Entry& e, Wrench& w) { w.value.wrench.at_center = readBoolean(e); }},
      {"start", [](const Entry& e, Wrench& w) { w.value.wrench.start = readNumber(e, "s"); }, true},
      {"end", [](const Entry& e, Wrench& w) { w.value.wrench.end = readBound(e, "s"); }, true},
  };
  Wrench wrench{index, body, {}};
  wrench.value.wrench.point_frame = kWorld;
  readMapping(item, keys, wrench);
  return wrench.value;
}

ActuatorCommand readEntryOfCommand(const Entry& item, const BodyIndex& index, const Body& body) {
  using Command = OfBody<ActuatorCommand>;
  static const Keys<Command> keys = {
      {"actuator",
       [](const Entry& e, Command& c) { c.value.actuator = readActuatorName(e, c.body); }, true},
      {"value", [](const Entry& e, Command& c) { c.value.value = readNumber(e, ""); }, true},
      {"start", [](const Entry& e, Command& c) { c.value.start = readNumber(e, "s"); }, true},
      {"end", [](const Entry& e, Command& c) { c.value.end = readBound(e, "s"); }, true},
  };
  Command command{index, body, {}};
  readMapping(item, keys, command);
  return command.value;
}

/// An actuator's state, and which one it is of.
struct NamedActuator {
  const Body& body;
  std::size_t index = 0;
  ActuatorState state{};
};

std::vector<ActuatorState> readActuatorStates(const Entry& value, const Body& body) {
  static const Keys<NamedActuator> keys = {
      {"name", [](const Entry& e, NamedActuator& a) { a.index = readActuatorName(e, a.body); },
       true},
      {"command", [](const Entry& e, NamedActuator& a) { a.state.command = readNumber(e, ""); },
       true},
      {"value", [](const Entry& e, NamedActuator& a) { a.state.value = readNumber(e, ""); }, true},
      {"since", [](const Entry& e, NamedActuator& a) { a.state.since = readNumber(e, "s"); }, true},
      {"until", [](const Entry& e, NamedActuator& a) { a.state.until = readBound(e, "s"); }, true},
      {"saturations",
       [](const Entry& e, NamedActuator& a) {
         a.state.saturations = static_cast<std::int64_t>(readCount(e));
       },
       true},
  };
  const std::size_t count = body.actuators.size();
  const std::vector<Entry> items = value.items("must be a list of actuators");
  if (items.size() != count)
    value.fail("actuators must be the " + std::to_string(count) + " of the body, got " +
               std::to_string(items.size()));
  std::vector<ActuatorState> states;
  for (const Entry& item : items) {
    NamedActuator actuator{body};
    readMapping(item, keys, actuator);
    const std::string &expected = body.actuators[states.size()].name,
                      &got = body.actuators[actuator.index].name;
    if (got != expected)
      item.fail("actuators must be in the order of the scene: '" + expected + "' here, got '" +
                got + "'");
    states.push_back(actuator.state);
  }
  return states;
}

void requireSame(const Entry& value, double got, double expected) {
  if (got != expected)
    value.failRule("must be " + shortest(expected) +
                   ", as in this scene or in the files that it names");
}

/// The places of one body in a state of a world.
struct BodyPlace {
  const World& world;
  const BodyIndex& index;
  std::size_t body;
  State& state;
  std::optional<Body> changed{};
  const Body& of() const { return changed ? *changed : unchangedBodies(world)[body]; }
};

BodyState& stateOf(BodyPlace& place) { return place.state.bodies[place.body]; }

MassProperties readMassProperties(const Entry& value) {
  static const Keys<MassProperties> keys = {
      {"mass", [](const Entry& e, MassProperties& m) { m.mass = readNumber(e, "kg"); }, true},
      {"center_of_mass", [](const Entry& e, MassProperties& m) { m.com_B = readVector3(e, "m"); },
       true},
      {"inertia",
       [](const Entry& e, MassProperties& m) {
         const std::vector<double> I = readNumbers(e, 6, "kg m^2");
         m.I_Bcm << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
       },
       true},
  };
  MassProperties properties;
  readMapping(value, keys, properties);
  return properties;
}

void readChange(const Entry& value, BodyPlace& place) {
  const MassProperties properties = readMassProperties(value);
  try {
    place.changed = changedBody(place.of(), properties);
  } catch (const std::invalid_argument& fault) {
    value.fail(fault.what());
  }
  place.state.changes[place.body].properties_B = properties;
}

void readWrenchEntries(const Entry& value, BodyPlace& place) {
  for (const Entry& item : value.items("must be a list of wrenches")) {
    ScheduledWrench entry = readEntry(item, place.index, place.of());
    entry.wrench.body = place.body;
    place.state.schedules[place.body].wrenches.push_back(std::move(entry));
  }
}

void readCommandEntries(const Entry& value, BodyPlace& place) {
  for (const Entry& item : value.items("must be a list of commands")) {
    ActuatorCommand command = readEntryOfCommand(item, place.index, place.of());
    command.body = place.body;
    place.state.schedules[place.body].commands.push_back(command);
  }
}

void checkMoments(const Entry& value, const Body& body) {
  const Vector3d moments = readVector3(value, "kg m^2");
  for (int k = 0; k < 3; ++k) requireSame(value, moments(k), body.I(k));
}

}  // namespace

void readStateOfBody(const Entry& list_item, const World& world, const BodyIndex& index,
                     std::size_t body, State& state) {
  static const Keys<BodyPlace> keys = withState<BodyPlace, stateOf>({
      {"name", [](const Entry&, BodyPlace&) {}, true},
      {"absent",
       [](const Entry& e, BodyPlace& b) { b.state.changes[b.body].absent = readBoolean(e); }},
      {"mass_properties", readChange},
      {"mass",
       [](const Entry& e, BodyPlace& b) { requireSame(e, readNumber(e, "kg"), b.of().mass); }},
      {"moments", [](const Entry& e, BodyPlace& b) { checkMoments(e, b.of()); }},
      {"anchor", [](const Entry& e, BodyPlace& b) { b.state.anchors[b.body] = readAnchor(e); }},
      {"actuators",
       [](const Entry& e, BodyPlace& b) {
         b.state.actuators[b.body] = readActuatorStates(e, b.of());
       }},
      {"wrenches", readWrenchEntries},
      {"commands", readCommandEntries},
  });
  const Entry entry = list_item.as("body '" + world.bodies[body].name + "'");
  BodyPlace place{world, index, body, state, std::nullopt};
  readMapping(entry, keys, place);
}

std::size_t readBodyName(const Entry& value, const BodyIndex& index) {
  const auto body = index.find(readName(value));
  if (body == index.end()) value.failRule("must be a body of the scene");
  return body->second;
}

std::size_t readCount(const Entry& value) {
  const double count = readNumber(value, "");
  if (!(count >= 0) || count != std::floor(count) || count >= kMaxSteps)
    value.failRule("must be a whole number >= 0");
  return static_cast<std::size_t>(count);
}

}  // namespace rigid_body_sim
