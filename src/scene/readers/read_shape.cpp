#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

/// Three lengths > 0.
Vector3d readSize(const Entry& value) {
  const std::string rule = "must be a list of 3 numbers [m]";
  const std::vector<Entry> items = value.items(rule);
  if (items.size() != 3) value.failRule(rule);
  return {readPositive(items[0], "m"), readPositive(items[1], "m"), readPositive(items[2], "m")};
}

Shape readSphere(const Entry& value) {
  static const std::vector<Key<Sphere>> keys = {
      {"radius", [](const Entry& e, Sphere& s) { s.radius = readPositive(e, "m"); }, true},
  };
  Sphere sphere{};
  readMapping(value, keys, sphere);
  return sphere;
}

Shape readCapsule(const Entry& value) {
  static const std::vector<Key<Capsule>> keys = {
      {"radius", [](const Entry& e, Capsule& c) { c.radius = readPositive(e, "m"); }, true},
      {"length", [](const Entry& e, Capsule& c) { c.length = readNotNegative(e, "m"); }, true},
  };
  Capsule capsule{};
  readMapping(value, keys, capsule);
  return capsule;
}

/// A solid of revolution with a radius and a length.
template <class Solid>
Shape readRound(const Entry& value) {
  static const std::vector<Key<Solid>> keys = {
      {"radius", [](const Entry& e, Solid& s) { s.radius = readPositive(e, "m"); }, true},
      {"length", [](const Entry& e, Solid& s) { s.length = readPositive(e, "m"); }, true},
  };
  Solid solid{};
  readMapping(value, keys, solid);
  return solid;
}

}  // namespace

SolidGeometry readGeometry(const Entry& entry) {
  const auto refusePlane = [](const Entry& e, SolidGeometry&) {
    e.fail(e.key() + " must be the only shape of a fixed body: shape: {plane: {}}, fixed: true");
  };
  using Geometry = SolidGeometry;
  static const std::vector<Key<Geometry>> keys = {
      {"box", [](const Entry& e, Geometry& g) { g = Box{readSize(e)}; }},
      {"sphere", [](const Entry& e, Geometry& g) { g = readSphere(e); }},
      {"cylinder", [](const Entry& e, Geometry& g) { g = readRound<Cylinder>(e); }},
      {"capsule", [](const Entry& e, Geometry& g) { g = readCapsule(e); }},
      {"ellipsoid", [](const Entry& e, Geometry& g) { g = Ellipsoid{readSize(e)}; }},
      {"cone", [](const Entry& e, Geometry& g) { g = readRound<Cone>(e); }},
      {"mesh", [](const Entry& e, Geometry& g) { g = readMeshDef(e); }},
      {"plane", refusePlane},
  };
  SolidGeometry geometry;
  readMapping(entry, keys, geometry);
  const std::size_t count = entry.node().children().size();
  if (count != 1) entry.fail(entry.key() + " must name one shape, got " + std::to_string(count));
  return geometry;
}

}  // namespace rigid_body_sim
