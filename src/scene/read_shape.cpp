#include "readers.hpp"

namespace rigid_body_sim {
namespace {

Shape readBox(const Entry& value) {
  Vector3d size;
  const std::vector<Entry> items = value.items("must be a list of 3 numbers [m]");
  if (items.size() != 3) value.failRule("must be a list of 3 numbers [m]");
  for (int i = 0; i < 3; ++i) size(i) = readPositive(items[static_cast<std::size_t>(i)], "m");
  return Box{size};
}

Shape readSphere(const Entry& value) {
  const std::vector<Key<Sphere>> keys = {
      {"radius", [](const Entry& e, Sphere& s) { s.radius = readPositive(e, "m"); }, true},
  };
  Sphere sphere{};
  readMapping(value, keys, sphere);
  return sphere;
}

Shape readCylinder(const Entry& value) {
  const std::vector<Key<Cylinder>> keys = {
      {"radius", [](const Entry& e, Cylinder& c) { c.radius = readPositive(e, "m"); }, true},
      {"length", [](const Entry& e, Cylinder& c) { c.length = readPositive(e, "m"); }, true},
  };
  Cylinder cylinder{};
  readMapping(value, keys, cylinder);
  return cylinder;
}

}  // namespace

Shape readShape(const Entry& entry) {
  const std::vector<Key<Shape>> keys = {
      {"box", [](const Entry& e, Shape& s) { s = readBox(e); }},
      {"sphere", [](const Entry& e, Shape& s) { s = readSphere(e); }},
      {"cylinder", [](const Entry& e, Shape& s) { s = readCylinder(e); }},
  };
  Shape shape;
  readMapping(entry, keys, shape);
  const std::size_t count = entry.node().children.size();
  if (count != 1) entry.fail("shape must name one shape, got " + std::to_string(count));
  return shape;
}

}  // namespace rigid_body_sim
