#include "scene/files/viewer_url.hpp"
#include "scene/limits.hpp"
#include "scene/readers/file_reference.hpp"
#include "scene/readers/readers.hpp"
#include "scene/readers/suspicious.hpp"

namespace rigid_body_sim {
namespace {

/// Whether a twist is given in body axes; the names of both frames stand for them, too.
bool readTwistFrame(const Entry& value, const BodyDef& body) {
  const std::string_view text = value.node().text();
  if (text == "world") return false;
  if (text == "body" || text == body.name || text == frameOf(body)) return true;
  if (text == value.context().world_frame) return false;
  value.failRule("must be world or body");
}

TwistDef readTwist(const Entry& entry, const BodyDef& body) {
  static const std::vector<Key<TwistDef>> keys = {
      {"frame", [](const Entry&, TwistDef&) {}, true},
      {"linear", [](const Entry& e, TwistDef& t) { t.linear = readVector3(e, "m/s"); }},
      {"angular", [](const Entry& e, TwistDef& t) { t.angular = readVector3(e, "rad/s"); }},
  };
  TwistDef twist;
  twist.line = entry.node().line();
  readMapping(entry, keys, twist);
  twist.names_linear = entry.node().find("linear") != nullptr;
  twist.in_body_axes = readTwistFrame(entry.child(*entry.node().find("frame")), body);
  return twist;
}

PivotDef readPivot(const Entry& entry) {
  static const std::vector<Key<PivotDef>> keys = {
      {"point", [](const Entry& e, PivotDef& p) { p.point = readVector3(e, "m"); }, true},
  };
  PivotDef pivot;
  pivot.line = entry.node().line();
  readMapping(entry, keys, pivot);
  return pivot;
}

PointDef readPoint(const Entry& entry) {
  static const std::vector<Key<PointDef>> keys = {
      {"position", [](const Entry& e, PointDef& p) { p.position = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, PointDef& p) { p.orientation = readOrientation(e); }},
  };
  PointDef point;
  point.name = std::string(entry.node().key());
  point.line = entry.node().line();
  if (!isName(point.name)) entry.fail("points: '" + printable(point.name) + "' " + nameRule());
  readMapping(entry, keys, point);
  return point;
}

std::vector<PointDef> readPoints(const Entry& entry) {
  if (entry.node().kind() != YamlNode::Kind::kMapping)
    entry.failRule("must be a mapping of names to frames");
  entry.checkCount(kMaxPoints, "points");
  std::vector<PointDef> points;
  for (const YamlNode& node : entry.node().children())
    points.push_back(readPoint(entry.child(node)));
  return points;
}

Color readColor(const Entry& value) {
  const std::vector<double> rgba = readNumbers(value, 4, "");
  for (const double c : rgba) {
    if (!(c >= 0 && c <= 1)) value.failRule("must be [r, g, b, a], each 0 to 1");
  }
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

/// A factor, or one for each axis.
Vector3d readScale(const Entry& value) {
  if (value.node().kind() != YamlNode::Kind::kList)
    return Vector3d::Constant(readPositive(value, ""));
  const std::string rule = "must be a number or a list of 3 numbers";
  const std::vector<Entry> items = value.items(rule);
  if (items.size() != 3) value.failRule(rule);
  return {readPositive(items[0], ""), readPositive(items[1], ""), readPositive(items[2], "")};
}

VisualDef readVisual(const Entry& entry) {
  const auto readMesh = [](const Entry& e, VisualDef& v) {
    v.mesh = viewerUrl(readText(e), e.context().directory);
    noteDrawnFile(v.mesh, e.context());
  };
  static const std::vector<Key<VisualDef>> keys = {
      {"mesh", readMesh},
      {"scale", [](const Entry& e, VisualDef& v) { v.scale = readScale(e); }},
      {"position", [](const Entry& e, VisualDef& v) { v.position = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, VisualDef& v) { v.orientation = readOrientation(e); }},
      {"color", [](const Entry& e, VisualDef& v) { v.color = readColor(e); }},
  };
  VisualDef visual;
  readMapping(entry, keys, visual);
  for (const char* key : {"scale", "position", "orientation"}) {
    const YamlNode* node = entry.node().find(key);
    if (node && visual.mesh.empty()) entry.child(*node).failRule("goes with visual.mesh");
  }
  return visual;
}

void readBodyName(const Entry& value, BodyDef& body) {
  body.name = readName(value);
  body.line = value.node().line();
}

/// The body by its name as far as it can be told, else by its place in the list.
std::string placeOf(const Entry& entry) {
  const YamlNode* name = entry.node().find("name");
  return name && isName(name->text()) ? "body '" + std::string(name->text()) + "'" : entry.key();
}

}  // namespace

bool readBodyKey(const Entry& list_item, std::string_view key, BodyDef& body) {
  const Entry entry = list_item.as(placeOf(list_item));
  const Entry value = entry.child(*entry.node().find(key));
  if (key == "position")
    body.position = readVector3(value, "m");
  else if (key == "orientation")
    body.orientation = readOrientation(value);
  else if (key == "twist")
    body.twist = readTwist(value, body);
  else if (key == "mass" && std::holds_alternative<SolidDef>(body.composition))
    readComposition(entry, body);
  else
    return false;
  return true;
}

BodyDef readBody(const Entry& list_item) {
  const auto later = [](const Entry&, BodyDef&) {};  // those that depend on others
  static const std::vector<Key<BodyDef>> keys = {
      {"name", readBodyName, true},
      {"frame", [](const Entry& e, BodyDef& b) { b.frame = readFrameName(e); }},
      {"shape", later},
      {"mass", later},
      {"density", later},
      {"inertia", later},
      {"center_of_mass", later},
      {"parts", later},
      {"particles", later},
      {"urdf", later},
      {"impossible_inertia", later},
      {"position", [](const Entry& e, BodyDef& b) { b.position = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, BodyDef& b) { b.orientation = readOrientation(e); }},
      {"twist", later},
      {"pivot", [](const Entry& e, BodyDef& b) { b.pivot = readPivot(e); }},
      {"drag", [](const Entry& e, BodyDef& b) { b.drag = readDrag(e); }},
      {"buoyancy", [](const Entry& e, BodyDef& b) { b.buoyancy = readBuoyancy(e); }},
      {"points", [](const Entry& e, BodyDef& b) { b.points = readPoints(e); }},
      {"collision", [](const Entry& e, BodyDef& b) { b.collision = readCollision(e); }},
      {"thrusters", [](const Entry& e, BodyDef& b) { b.actuators.thrusters = readThrusters(e); }},
      {"rotors", [](const Entry& e, BodyDef& b) { b.actuators.rotors = readRotors(e); }},
      {"wheels", [](const Entry& e, BodyDef& b) { b.actuators.wheels = readWheels(e); }},
      {"imus", [](const Entry& e, BodyDef& b) { b.imus = readImus(e); }},
      {"fixed", [](const Entry& e, BodyDef& b) { b.fixed = readBoolean(e); }},
      {"absent", [](const Entry& e, BodyDef& b) { b.absent = readBoolean(e); }},
      {"visual", [](const Entry& e, BodyDef& b) { b.visual = readVisual(e); }},
  };
  const Entry entry = list_item.as(placeOf(list_item));
  BodyDef body;
  readMapping(entry, keys, body);
  if (const YamlNode* twist = entry.node().find("twist"))
    body.twist = readTwist(entry.child(*twist), body);
  readComposition(entry, body);
  noteSuspicious(entry, body);
  return body;
}

}  // namespace rigid_body_sim
