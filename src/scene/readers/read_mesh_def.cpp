#include <stdexcept>

#include "scene/meshes/mesh_corners.hpp"
#include "scene/meshes/solid_mesh.hpp"
#include "scene/readers/file_reference.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

/// What an entry says of a mesh.
struct MeshEntry {
  FileReference file;
  Vector3d scale = Vector3d::Ones();
  MeshSolid solid = MeshSolid::kSurface;
};

MeshSolid readMeshSolid(const Entry& value) {
  const std::string_view name = value.node().text();
  if (name == "surface") return MeshSolid::kSurface;
  if (name == "hull") return MeshSolid::kHull;
  if (name == "box") return MeshSolid::kBox;
  value.failRule("must be surface, hull or box");
}

ReadContext::MeshKey keyOf(const std::string& path, const Vector3d& scale, MeshSolid solid) {
  return {path, {scale.x(), scale.y(), scale.z()}, solid};
}

MeshEntry readMeshEntry(const Entry& entry) {
  static const std::vector<Key<MeshEntry>> keys = {
      {"file", [](const Entry& e, MeshEntry& m) { m.file = readFileReference(e); }, true},
      {"scale", [](const Entry& e, MeshEntry& m) { m.scale = readMeshScale(e); }},
      {"solid", [](const Entry& e, MeshEntry& m) { m.solid = readMeshSolid(e); }},
  };
  MeshEntry mesh;
  readMapping(entry, keys, mesh);
  return mesh;
}

/// As cornersOf; throws SceneError. file: the entry that names the file.
HullCorners readCorners(const Entry& file, const MeshEntry& mesh) {
  try {
    return cornersOf(file.context(), mesh.file.path, mesh.scale, mesh.solid);
  } catch (const std::runtime_error& e) {
    file.fail(file.key() + ": " + e.what());
  }
}

/// The solid of the file that an entry names; one that two bodies name alike is read once.
const MeshDef& solidOf(const Entry& file, const MeshEntry& mesh) {
  ReadContext& context = file.context();
  const std::string& path = mesh.file.path;
  const ReadContext::MeshKey key = keyOf(path, mesh.scale, mesh.solid);
  const auto known = context.meshes.find(key);
  if (known != context.meshes.end()) return known->second;
  try {
    std::vector<std::string> notices;
    const MeshDef def = readSolidMesh(path, mesh.scale, mesh.solid, notices);
    for (const std::string& notice : notices) file.note(notice);
    return context.meshes[key] = def;
  } catch (const std::runtime_error& e) {
    file.fail(file.key() + ": " + e.what());
  }
}

}  // namespace

Vector3d readMeshScale(const Entry& value) {
  if (value.node().kind() == YamlNode::Kind::kScalar)
    return Vector3d::Constant(readPositive(value, ""));
  Vector3d scale = readVector3(value, "");
  if ((scale.array() == 0).any()) value.failRule("must be > 0 or three numbers other than 0");
  return scale;
}

MeshDef readMeshDef(const Entry& entry) {
  const MeshEntry mesh = readMeshEntry(entry);
  const Entry file = entry.child(*entry.node().find("file"));
  MeshDef def = solidOf(file, mesh);
  def.url = mesh.file.url;
  if (entry.context().has_contact) def.corners = readCorners(file, mesh);
  return def;
}

HullDef readHullDef(const Entry& entry) {
  const MeshEntry mesh = readMeshEntry(entry);
  return {mesh.file.url, mesh.scale, readCorners(entry.child(*entry.node().find("file")), mesh)};
}

HullCorners cornersOf(ReadContext& context, const std::string& path, const Vector3d& scale,
                      MeshSolid solid) {
  HullCorners& corners = context.corners[keyOf(path, scale, solid)];
  if (!corners)
    corners = std::make_shared<const std::vector<Vector3d>>(meshCorners(path, scale, solid));
  return corners;
}

}  // namespace rigid_body_sim
