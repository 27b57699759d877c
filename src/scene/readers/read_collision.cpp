#include "scene/limits.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

std::variant<Shape, HullDef> readTouchingGeometry(const Entry& shape) {
  const YamlNode* mesh = shape.node().find("mesh");
  if (mesh && shape.node().children().size() == 1) return readHullDef(shape.child(*mesh));
  return std::get<Shape>(readGeometry(shape));  // which refuses a mesh beside another shape
}

CollisionDef readCollisionSolid(const Entry& entry) {
  static const std::vector<Key<CollisionDef>> keys = {
      {"shape", [](const Entry& e, CollisionDef& c) { c.geometry = readTouchingGeometry(e); },
       true},
      {"position", [](const Entry& e, CollisionDef& c) { c.position = readVector3(e, "m"); }},
      {"orientation", [](const Entry& e, CollisionDef& c) { c.orientation = readOrientation(e); }},
  };
  CollisionDef solid;
  readMapping(entry, keys, solid);
  return solid;
}

}  // namespace

std::vector<CollisionDef> readCollision(const Entry& entry) {
  entry.checkCount(kMaxCollisionShapes, "shapes");
  std::vector<CollisionDef> solids;
  for (const Entry& item : entry.items("must be a list of shapes, each with its place"))
    solids.push_back(readCollisionSolid(item));
  return solids;
}

}  // namespace rigid_body_sim
