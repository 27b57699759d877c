#include "scene/readers/readers.hpp"

/// What a scene says of the medium, and what it does to a body.
namespace rigid_body_sim {
namespace {

/// One number, alike in every direction, or three, along the axes of the body frame.
void readDragKey(const Entry& value, const std::string& unit, double& alike, Vector3d& axes) {
  if (value.node().kind() != YamlNode::Kind::kList) {
    alike = readNotNegative(value, unit);
    return;
  }
  const std::string rule = "must be a number or a list of 3 numbers [" + unit + "]";
  const std::vector<Entry> items = value.items(rule);
  if (items.size() != 3) value.failRule(rule);
  for (int i = 0; i < 3; ++i) axes[i] = readNotNegative(items[static_cast<std::size_t>(i)], unit);
}

}  // namespace

MediumDef readMedium(const Entry& entry) {
  static const std::vector<Key<MediumDef>> keys = {
      {"density", [](const Entry& e, MediumDef& m) { m.density = readNotNegative(e, "kg/m^3"); }},
      {"velocity", [](const Entry& e, MediumDef& m) { m.velocity = readVector3(e, "m/s"); }},
  };
  MediumDef medium;
  readMapping(entry, keys, medium);
  return medium;
}

DragDef readDrag(const Entry& entry) {
  static const std::vector<Key<DragDef>> keys = {
      {"linear",
       [](const Entry& e, DragDef& d) { readDragKey(e, "N s/m", d.linear, d.linear_axes); }},
      {"quadratic", [](const Entry& e,
                       DragDef& d) { readDragKey(e, "N s^2/m^2", d.quadratic, d.quadratic_axes); }},
      {"angular",
       [](const Entry& e, DragDef& d) { readDragKey(e, "N m s", d.angular, d.angular_axes); }},
      {"center", [](const Entry& e, DragDef& d) { d.center = readVector3(e, "m"); }},
  };
  DragDef drag;
  readMapping(entry, keys, drag);
  return drag;
}

std::optional<BuoyancyDef> readBuoyancy(const Entry& entry) {
  static const std::vector<Key<BuoyancyDef>> keys = {
      {"volume", [](const Entry& e, BuoyancyDef& b) { b.volume = readPositive(e, "m^3"); }, true},
      {"center", [](const Entry& e, BuoyancyDef& b) { b.center = readVector3(e, "m"); }},
  };
  BuoyancyDef buoyancy;
  buoyancy.line = entry.node().line();
  if (entry.node().kind() == YamlNode::Kind::kMapping) {
    readMapping(entry, keys, buoyancy);
    return buoyancy;
  }
  if (entry.node().text() != "true" && entry.node().text() != "false")
    entry.failRule("must be true, false or {volume: .., center: [x, y, z]}");
  return readBoolean(entry) ? std::optional<BuoyancyDef>(buoyancy) : std::nullopt;
}

}  // namespace rigid_body_sim
