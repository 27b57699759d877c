#include <stdexcept>
#include <utility>

#include <rigid_body_sim/mass/checked_mesh.hpp>
#include <rigid_body_sim/scene/read_mesh.hpp>

#include "file_reference.hpp"
#include "readers.hpp"

namespace rigid_body_sim {
namespace {

/// What the file holds, orientation put right. file: the entry that names it, for messages.
TriangleMesh solidMesh(const Entry& file, const std::string& path, double scale) {
  CheckedMesh checked;
  try {
    checked = checkedMesh(readMesh(path, scale));
  } catch (const std::runtime_error& e) {
    file.fail(file.key() + ": " + e.what());
  }
  const std::string where = file.key() + ": " + path + ": ";
  if (!checked.fault.empty()) file.fail(where + checked.fault);
  if (!checked.notice.empty())
    file.context().notices.push_back(file.located(where + checked.notice));
  return std::move(checked.mesh);
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

  const auto [known, is_new] =
      entry.context().meshes.try_emplace({named.file.path, named.scale}, MeshDef{});
  MeshDef& def = known->second;
  if (is_new) {
    const Entry file = entry.child(*entry.node().find("file"));
    const TriangleMesh mesh = solidMesh(file, named.file.path, named.scale);
    def.scale = named.scale;
    def.volume = volume(mesh);
    def.unit = massProperties(mesh, 1);
  }
  def.url = named.file.url;
  return def;
}

}  // namespace rigid_body_sim
