#include <initializer_list>
#include <optional>

#include "scene/build/body_mass.hpp"
#include "scene/build/inertia_rules.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

/// Refuses the keys that stand in the mapping.
void refuse(const Entry& mapping, std::initializer_list<const char*> keys, const char* rule) {
  for (const char* key : keys) {
    if (const YamlNode* node = mapping.node().find(key)) mapping.child(*node).failRule(rule);
  }
}

/// As refuse, for keys whose values follow from that of the key `source`.
void refuseGiven(const Entry& mapping, std::initializer_list<const char*> keys,
                 std::string_view source) {
  for (const char* key : keys)
    if (const YamlNode* node = mapping.node().find(key))
      mapping.child(*node).failRule("cannot stand beside " + std::string(source) +
                                    ", which gives it");
}

[[noreturn]] void failMissing(const Entry& mapping, const std::string& what) {
  mapping.fail((mapping.key().empty() ? "" : mapping.key() + ": ") + "missing " + what);
}

std::optional<double> readOptional(const Entry& mapping, const char* key, const std::string& unit) {
  const YamlNode* node = mapping.node().find(key);
  if (!node) return std::nullopt;
  return readPositive(mapping.child(*node), unit);
}

/// Whether moments that break the triangle inequality are raised to meet it.
bool readBalance(const Entry& body) {
  const YamlNode* node = body.node().find("impossible_inertia");
  if (!node) return false;
  if (node->text() == "balance") return true;
  if (node->text() != "refuse") body.child(*node).failRule("must be refuse or balance");
  return false;
}

/// The keys that go with others.
struct MassKeys {
  std::optional<double> mass, density;
  bool balance = false;
};

MassKeys readMassKeys(const Entry& mapping, bool balance) {
  return {readOptional(mapping, "mass", "kg"), readOptional(mapping, "density", "kg/m^3"), balance};
}

/// The mapping names a shape, with mass or density.
SolidDef readSolid(const Entry& mapping, const MassKeys& keys) {
  refuseGiven(mapping, {"inertia", "center_of_mass"}, "shape");
  const SolidGeometry geometry = readGeometry(mapping.child(*mapping.node().find("shape")));
  if (keys.mass) refuse(mapping, {"density"}, "cannot stand beside mass");
  if (!keys.mass && !keys.density) failMissing(mapping, "key 'mass' or 'density' of the shape");
  return {geometry, keys.mass ? *keys.mass : *keys.density * volumeOf(geometry)};
}

Matrix3d readInertia(const Entry& entry) {
  // an entry and its mirror image across the diagonal
  static const std::vector<Key<Matrix3d>> keys = {
      {"ixx", [](const Entry& e, Matrix3d& I) { I(0, 0) = readNumber(e, "kg m^2"); }, true},
      {"iyy", [](const Entry& e, Matrix3d& I) { I(1, 1) = readNumber(e, "kg m^2"); }, true},
      {"izz", [](const Entry& e, Matrix3d& I) { I(2, 2) = readNumber(e, "kg m^2"); }, true},
      {"ixy", [](const Entry& e, Matrix3d& I) { I(0, 1) = I(1, 0) = readNumber(e, "kg m^2"); }},
      {"ixz", [](const Entry& e, Matrix3d& I) { I(0, 2) = I(2, 0) = readNumber(e, "kg m^2"); }},
      {"iyz", [](const Entry& e, Matrix3d& I) { I(1, 2) = I(2, 1) = readNumber(e, "kg m^2"); }},
  };
  Matrix3d inertia = Matrix3d::Zero();
  readMapping(entry, keys, inertia);
  return inertia;
}

/// The mapping names mass and inertia.
MassProperties readGiven(const Entry& mapping, const MassKeys& keys) {
  const Matrix3d inertia = readInertia(mapping.child(*mapping.node().find("inertia")));
  refuse(mapping, {"density"}, "needs a shape");
  if (!keys.mass) failMissing(mapping, "key 'mass'");
  const YamlNode* center = mapping.node().find("center_of_mass");
  MassProperties given = {
      *keys.mass, center ? readVector3(mapping.child(*center), "m") : Vector3d::Zero(), inertia};
  const std::string notice = keys.balance ? balanceInertia(given) : "";
  if (!notice.empty()) mapping.child(*mapping.node().find("inertia")).note(notice);
  return given;
}

PartDef readPart(const Entry& entry, bool balance) {
  const auto later = [](const Entry&, PartDef&) {};
  static const std::vector<Key<PartDef>> keys = {
      {"shape", later},
      {"mass", later},
      {"density", later},
      {"inertia", later},
      {"center_of_mass", later},
      {"position", [](const Entry& e, PartDef& p) { p.position = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, PartDef& p) { p.orientation = readOrientation(e); }},
  };
  PartDef part;
  readMapping(entry, keys, part);
  part.line = entry.node().line();
  const MassKeys mass = readMassKeys(entry, balance);
  if (entry.node().find("shape"))
    part.content = readSolid(entry, mass);
  else if (entry.node().find("inertia"))
    part.content = readGiven(entry, mass);
  else
    failMissing(entry, "key 'shape' or 'inertia'");
  return part;
}

std::vector<PartDef> readParts(const Entry& entry, bool balance) {
  const std::string rule = "must be a list of at least one part";
  std::vector<PartDef> parts;
  for (const Entry& item : entry.items(rule)) parts.push_back(readPart(item, balance));
  if (parts.empty()) entry.failRule(rule);
  return parts;
}

Particle readParticle(const Entry& entry) {
  static const std::vector<Key<Particle>> keys = {
      {"mass", [](const Entry& e, Particle& p) { p.mass = readPositive(e, "kg"); }, true},
      {"position", [](const Entry& e, Particle& p) { p.position = readVector3(e, "m"); }, true},
  };
  Particle particle;
  readMapping(entry, keys, particle);
  return particle;
}

Particles readParticles(const Entry& entry) {
  const std::string rule = "must be a list of at least one particle";
  Particles particles;
  for (const Entry& item : entry.items(rule)) particles.push_back(readParticle(item));
  if (particles.empty()) entry.failRule(rule);
  return particles;
}

/// The one key that says what a body is made of. `inertia` comes last, since a shape may be named
/// beside it by mistake: then it is the inertia that is refused.
const YamlNode& compositionKey(const Entry& body) {
  const YamlNode* found = nullptr;
  for (const char* key : {"shape", "parts", "particles", "urdf", "inertia"}) {
    const YamlNode* node = body.node().find(key);
    if (node && found && node->key() != "inertia")
      body.child(*node).failRule("cannot stand beside " + std::string(found->key()) +
                                 ", as a body is made of one of them");
    if (!found) found = node;
  }
  if (!found)
    failMissing(body,
                "what the body is made of: shape, with mass or density; mass and inertia; parts; "
                "particles; or urdf");
  return *found;
}

/// Whether the value of `shape` names a plane and nothing else.
bool namesPlane(const YamlNode& shape) {
  return shape.find("plane") && shape.children().size() == 1;
}

/// The mapping of the body names a plane as its shape.
PlaneDef readPlane(const Entry& mapping) {
  refuse(mapping, {"mass", "density", "inertia", "center_of_mass"},
         "cannot stand beside shape.plane, which has no mass");
  const Entry shape = mapping.child(*mapping.node().find("shape"));
  const Entry plane = shape.child(*shape.node().find("plane"));
  if (plane.node().kind() != YamlNode::Kind::kMapping || !plane.node().children().empty())
    plane.failRule("must be {}: it is the plane z = 0 of the body frame");
  return {};
}

CompositionDef compositionOf(const Entry& entry, const YamlNode& key, const MassKeys& mass,
                             BodyDef& body) {
  if (key.key() == "inertia") return readGiven(entry, mass);
  if (key.key() == "shape" || key.key() == "particles")
    refuse(entry, {"impossible_inertia"}, "goes with inertia, parts or urdf");
  if (key.key() == "shape" && namesPlane(key)) return readPlane(entry);
  if (key.key() == "shape") return readSolid(entry, mass);
  refuseGiven(entry, {"inertia", "center_of_mass", "mass", "density"}, key.key());
  const Entry value = entry.child(key);
  if (key.key() == "parts") return readParts(value, mass.balance);
  if (key.key() == "particles") return readParticles(value);
  const bool touches = entry.context().has_contact && !body.collision;
  LinkedBody linked = readLink(value, {mass.balance, touches});
  body.points.insert(body.points.end(), linked.points.begin(), linked.points.end());
  return std::move(linked.def);
}

}  // namespace

void readComposition(const Entry& entry, BodyDef& body) {
  // a bad value is refused before a key that is missing
  const MassKeys mass = readMassKeys(entry, readBalance(entry));
  const YamlNode& key = compositionKey(entry);
  body.composition = compositionOf(entry, key, mass, body);
  body.composition_line = key.line();
}

}  // namespace rigid_body_sim
