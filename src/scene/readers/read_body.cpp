#include "scene/files/file_reference.hpp"
#include "scene/limits.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

/// Whether a twist is given in body axes.
bool readTwistFrame(const Entry& value) {
  if (value.node().text == "world") return false;
  if (value.node().text == "body") return true;
  value.failRule("must be world or body");
}

TwistDef readTwist(const Entry& entry) {
  const std::vector<Key<TwistDef>> keys = {
      {"frame", [](const Entry& e, TwistDef& t) { t.in_body_axes = readTwistFrame(e); }, true},
      {"linear", [](const Entry& e, TwistDef& t) { t.linear = readVector3(e, "m/s"); }},
      {"angular", [](const Entry& e, TwistDef& t) { t.angular = readVector3(e, "rad/s"); }},
  };
  TwistDef twist;
  twist.line = entry.node().line;
  readMapping(entry, keys, twist);
  return twist;
}

PointDef readPoint(const Entry& entry) {
  const std::vector<Key<PointDef>> keys = {
      {"position", [](const Entry& e, PointDef& p) { p.position = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, PointDef& p) { p.orientation = readQuaternion(e); }},
  };
  PointDef point;
  point.name = entry.node().key;
  point.line = entry.node().line;
  if (!isName(point.name)) entry.fail("points: '" + printable(point.name) + "' " + nameRule());
  readMapping(entry, keys, point);
  return point;
}

std::vector<PointDef> readPoints(const Entry& entry) {
  if (entry.node().kind != YamlNode::Kind::kMapping)
    entry.failRule("must be a mapping of names to frames");
  entry.checkCount(kMostPoints, "points");
  std::vector<PointDef> points;
  for (const YamlNode& node : entry.node().children) points.push_back(readPoint(entry.child(node)));
  return points;
}

Color readColor(const Entry& value) {
  const std::vector<double> rgba = readNumbers(value, 4, "");
  for (const double c : rgba) {
    if (!(c >= 0 && c <= 1)) value.failRule("must be [r, g, b, a], each 0 to 1");
  }
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

VisualDef readVisual(const Entry& entry) {
  const std::vector<Key<VisualDef>> keys = {
      {"mesh", [](const Entry& e,
                  VisualDef& v) { v.mesh = viewerUrl(readText(e), e.context().directory); }},
      {"color", [](const Entry& e, VisualDef& v) { v.color = readColor(e); }},
  };
  VisualDef visual;
  readMapping(entry, keys, visual);
  return visual;
}

void readBodyName(const Entry& value, BodyDef& body) {
  body.name = readName(value);
  body.line = value.node().line;
}

/// The body by its name as far as it can be told, else by its place in the list.
std::string placeOf(const Entry& entry) {
  const YamlNode* name = entry.node().find("name");
  return name && isName(name->text) ? "body '" + name->text + "'" : entry.key();
}

}  // namespace

BodyDef readBody(const Entry& list_item) {
  const auto later = [](const Entry&, BodyDef&) {};  // several keys together: readComposition
  const std::vector<Key<BodyDef>> keys = {
      {"name", readBodyName, true},
      {"shape", later},
      {"mass", later},
      {"density", later},
      {"inertia", later},
      {"center_of_mass", later},
      {"parts", later},
      {"particles", later},
      {"urdf", later},
      {"position", [](const Entry& e, BodyDef& b) { b.position = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, BodyDef& b) { b.orientation = readQuaternion(e); }},
      {"twist", [](const Entry& e, BodyDef& b) { b.twist = readTwist(e); }},
      {"drag", [](const Entry& e, BodyDef& b) { b.drag = readDrag(e); }},
      {"points", [](const Entry& e, BodyDef& b) { b.points = readPoints(e); }},
      {"fixed", [](const Entry& e, BodyDef& b) { b.fixed = readBoolean(e); }},
      {"visual", [](const Entry& e, BodyDef& b) { b.visual = readVisual(e); }},
  };
  const Entry entry = list_item.as(placeOf(list_item));
  BodyDef body;
  readMapping(entry, keys, body);
  readComposition(entry, body);
  return body;
}

}  // namespace rigid_body_sim
