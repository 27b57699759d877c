#include <stdexcept>

#include "scene/files/file_reference.hpp"
#include "scene/meshes/solid_mesh.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

/// The solid of the file that an entry names; a file that two bodies name is read once.
const MeshDef& solidOf(const Entry& file, const std::string& path, double scale) {
  ReadContext& context = file.context();
  const auto known = context.meshes.find({path, scale});
  if (known != context.meshes.end()) return known->second;
  try {
    std::vector<std::string> notices;
    const MeshDef def = readSolidMesh(path, scale, notices);
    for (const std::string& notice : notices)
      context.notices.push_back(file.located(file.key() + ": " + notice));
    return context.meshes[{path, scale}] = def;
  } catch (const std::runtime_error& e) {
    file.fail(file.key() + ": " + e.what());
  }
}

}  // namespace

MeshDef readMeshDef(const Entry& entry) {
  struct Named {
    FileReference file;
    double scale = 1;
  };
  const std::vector<Key<Named>> keys = {
      {"file", [](const Entry& e, Named& n) { n.file = readFileReference(e); }, true},
      {"scale", [](const Entry& e, Named& n) { n.scale = readPositive(e, ""); }},
  };
  Named named;
  readMapping(entry, keys, named);
  const Entry file = entry.child(*entry.node().find("file"));
  MeshDef def = solidOf(file, named.file.path, named.scale);
  def.url = named.file.url;
  return def;
}

}  // namespace rigid_body_sim
