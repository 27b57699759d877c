#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

PartDef readPart(const Entry& entry) {
  const std::vector<Key<PartDef>> keys = {
      {"shape", [](const Entry& e, PartDef& p) { readSolid(e, p); }, true},
      {"mass", [](const Entry& e, PartDef& p) { p.mass = readPositive(e, "kg"); }},
      {"density", [](const Entry& e, PartDef& p) { p.density = readPositive(e, "kg/m^3"); }},
      {"position", [](const Entry& e, PartDef& p) { p.position = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, PartDef& p) { p.orientation = readQuaternion(e); }},
  };
  PartDef part;
  readMapping(entry, keys, part);
  checkSolid(entry, part);
  return part;
}

Particle readParticle(const Entry& entry) {
  const std::vector<Key<Particle>> keys = {
      {"mass", [](const Entry& e, Particle& p) { p.mass = readPositive(e, "kg"); }, true},
      {"position", [](const Entry& e, Particle& p) { p.position = readVector3(e, "m"); }, true},
  };
  Particle particle;
  readMapping(entry, keys, particle);
  return particle;
}

}  // namespace

Matrix3d readInertia(const Entry& entry) {
  // an entry and its mirror image across the diagonal
  const std::vector<Key<Matrix3d>> keys = {
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

std::vector<PartDef> readParts(const Entry& entry) {
  const std::string rule = "must be a list of at least one part";
  std::vector<PartDef> parts;
  for (const Entry& item : entry.items(rule)) parts.push_back(readPart(item));
  if (parts.empty()) entry.failRule(rule);
  return parts;
}

Particles readParticles(const Entry& entry) {
  const std::string rule = "must be a list of at least one particle";
  Particles particles;
  for (const Entry& item : entry.items(rule)) particles.push_back(readParticle(item));
  if (particles.empty()) entry.failRule(rule);
  return particles;
}

void checkSolid(const Entry& entry, const SolidDef& solid) {
  const YamlNode* density = entry.node().find("density");
  if (solid.mass && density) entry.child(*density).failRule("cannot stand beside mass");
  if (!solid.mass && !solid.density)
    entry.fail((entry.key().empty() ? "" : entry.key() + ": ") +
               "missing key 'mass' or 'density' of the shape");
}

int checkMatter(const Entry& entry, const BodyDef& body) {
  // the first key that says what the body is made of; inertia last, for it may also be said of one
  const YamlNode* matter = nullptr;
  for (const char* way : {"shape", "parts", "particles", "urdf", "inertia"}) {
    const YamlNode* node = entry.node().find(way);
    if (node && matter && node->key != "inertia")
      entry.child(*node).failRule("cannot stand beside " + matter->key +
                                  ", as a body is made of one of them");
    if (!matter) matter = node;
  }
  if (!matter)
    entry.fail(
        "missing what the body is made of: shape, with mass or density; mass and inertia; parts; "
        "particles; or urdf");

  const auto refuse = [&](const char* key, const std::string& rule) {
    if (const YamlNode* node = entry.node().find(key)) entry.child(*node).failRule(rule);
  };
  if (matter->key == "inertia") {
    refuse("density", "needs a shape");
    if (!body.mass) entry.fail("missing key 'mass'");
    return matter->line;
  }
  const std::string given = "cannot stand beside " + matter->key + ", which gives it";
  refuse("inertia", given);
  refuse("center_of_mass", given);
  if (matter->key == "shape") {
    checkSolid(entry, body);
  } else {
    refuse("mass", given);
    refuse("density", given);
  }
  return matter->line;
}

}  // namespace rigid_body_sim
