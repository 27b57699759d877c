#include "readers.hpp"

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
  const std::vector<Key<Sphere>> keys = {
      {"radius", [](const Entry& e, Sphere& s) { s.radius = readPositive(e, "m"); }, true},
  };
  Sphere sphere{};
  readMapping(value, keys, sphere);
  return sphere;
}

double readCapsuleLength(const Entry& value) {
  const double length = readNumber(value, "m");
  if (length < 0) value.failRule("must be >= 0 m");
  return length;
}

Shape readCapsule(const Entry& value) {
  const std::vector<Key<Capsule>> keys = {
      {"radius", [](const Entry& e, Capsule& c) { c.radius = readPositive(e, "m"); }, true},
      {"length", [](const Entry& e, Capsule& c) { c.length = readCapsuleLength(e); }, true},
  };
  Capsule capsule{};
  readMapping(value, keys, capsule);
  return capsule;
}

/// A solid of revolution with a radius and a length.
template <class Solid>
Shape readRound(const Entry& value) {
  const std::vector<Key<Solid>> keys = {
      {"radius", [](const Entry& e, Solid& s) { s.radius = readPositive(e, "m"); }, true},
      {"length", [](const Entry& e, Solid& s) { s.length = readPositive(e, "m"); }, true},
  };
  Solid solid{};
  readMapping(value, keys, solid);
  return solid;
}

}  // namespace

Shape readShape(const Entry& entry) {
  const std::vector<Key<Shape>> keys = {
      {"box", [](const Entry& e, Shape& s) { s = Box{readSize(e)}; }},
      {"sphere", [](const Entry& e, Shape& s) { s = readSphere(e); }},
      {"cylinder", [](const Entry& e, Shape& s) { s = readRound<Cylinder>(e); }},
      {"capsule", [](const Entry& e, Shape& s) { s = readCapsule(e); }},
      {"ellipsoid", [](const Entry& e, Shape& s) { s = Ellipsoid{readSize(e)}; }},
      {"cone", [](const Entry& e, Shape& s) { s = readRound<Cone>(e); }},
  };
  Shape shape;
  readMapping(entry, keys, shape);
  const std::size_t count = entry.node().children.size();
  if (count != 1) entry.fail("shape must name one shape, got " + std::to_string(count));
  return shape;
}

}  // namespace rigid_body_sim
