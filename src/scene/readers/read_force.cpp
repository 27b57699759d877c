#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

SpringEndDef readEnd(const Entry& entry) {
  static const std::vector<Key<SpringEndDef>> keys = {
      {"body", [](const Entry& e, SpringEndDef& s) { s.body = readText(e); }},
      {"point", [](const Entry& e, SpringEndDef& s) { s.point = readVector3(e, "m"); }},
      {"world", [](const Entry& e, SpringEndDef& s) { s.point = readVector3(e, "m"); }},
  };
  SpringEndDef end;
  end.line = entry.node().line();
  readMapping(entry, keys, end);
  const bool in_world = entry.node().find("world") != nullptr;
  if (in_world == (entry.node().find("body") != nullptr) ||
      (in_world && entry.node().find("point")))
    entry.failRule("must be {body: name, point: [x, y, z]} or {world: [x, y, z]}");
  return end;
}

SpringDef readSpring(const Entry& entry) {
  static const std::vector<Key<SpringDef>> keys = {
      {"type", [](const Entry&, SpringDef&) {}, true},
      {"from", [](const Entry& e, SpringDef& s) { s.from = readEnd(e); }, true},
      {"to", [](const Entry& e, SpringDef& s) { s.to = readEnd(e); }, true},
      {"stiffness", [](const Entry& e, SpringDef& s) { s.stiffness = readNotNegative(e, "N/m"); },
       true},
      {"damping", [](const Entry& e, SpringDef& s) { s.damping = readNotNegative(e, "N s/m"); }},
      {"rest_length",
       [](const Entry& e, SpringDef& s) { s.rest_length = readNotNegative(e, "m"); }},
  };
  SpringDef spring;
  readMapping(entry, keys, spring);
  return spring;
}

TetherDef readTether(const Entry& entry) {
  static const std::vector<Key<TetherDef>> keys = {
      {"type", [](const Entry&, TetherDef&) {}, true},
      {"from", [](const Entry& e, TetherDef& t) { t.from = readEnd(e); }, true},
      {"to", [](const Entry& e, TetherDef& t) { t.to = readEnd(e); }, true},
      {"stiffness", [](const Entry& e, TetherDef& t) { t.stiffness = readPositive(e, "N/m"); },
       true},
      {"damping", [](const Entry& e, TetherDef& t) { t.damping = readNotNegative(e, "N s/m"); }},
      {"length", [](const Entry& e, TetherDef& t) { t.length = readPositive(e, "m"); }, true},
  };
  TetherDef tether;
  readMapping(entry, keys, tether);
  return tether;
}

CentralGravityDef readCentralGravity(const Entry& entry) {
  static const std::vector<Key<CentralGravityDef>> keys = {
      {"type", [](const Entry&, CentralGravityDef&) {}, true},
      {"center", [](const Entry& e, CentralGravityDef& g) { g.center = readVector3(e, "m"); }},
      {"mu", [](const Entry& e, CentralGravityDef& g) { g.mu = readPositive(e, "m^3/s^2"); }, true},
      {"gradient", [](const Entry& e, CentralGravityDef& g) { g.gradient = readBoolean(e); }},
  };
  CentralGravityDef gravity;
  readMapping(entry, keys, gravity);
  return gravity;
}

/// How each law is read, by its `type`.
struct ForceType {
  const char* name;
  ForceLawDef (*read)(const Entry& entry);
};

const std::vector<ForceType>& forceTypes() {
  static const std::vector<ForceType> types = {
      {"central_gravity", [](const Entry& e) -> ForceLawDef { return readCentralGravity(e); }},
      {"contact", [](const Entry& e) -> ForceLawDef { return readContact(e); }},
      {"spring", [](const Entry& e) -> ForceLawDef { return readSpring(e); }},
      {"tether", [](const Entry& e) -> ForceLawDef { return readTether(e); }},
  };
  return types;
}

}  // namespace

ForceDef readForce(const Entry& list_item) {
  const Entry entry = list_item.as(list_item.key());
  if (entry.node().kind() != YamlNode::Kind::kMapping) entry.failRule("a mapping is expected");
  const YamlNode* type = entry.node().find("type");
  if (!type) entry.fail("missing key 'type'");
  std::string names;
  for (const ForceType& known : forceTypes()) {
    if (type->kind() == YamlNode::Kind::kScalar && type->text() == known.name)
      return {known.read(entry), entry.node().line()};
    names += (names.empty() ? "" : ", ") + std::string(known.name);
  }
  entry.child(*type).failRule("must be one of " + names);
}

}  // namespace rigid_body_sim
