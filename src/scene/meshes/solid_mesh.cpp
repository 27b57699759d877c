#include "scene/meshes/solid_mesh.hpp"

#include <stdexcept>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/files/file_reference.hpp"
#include "scene/meshes/read_mesh.hpp"

namespace rigid_body_sim {

MeshDef readSolidMesh(const std::string& path, double scale, std::vector<std::string>& notices) {
  const CheckedMesh checked = checkedMesh(readMesh(path, scale));
  if (!checked.fault.empty()) throw std::runtime_error(path + ": " + checked.fault);
  if (!checked.notice.empty()) notices.push_back(path + ": " + checked.notice);
  MeshDef def;
  def.url = viewerUrl(path, "");
  def.scale = scale;
  def.volume = volume(checked.mesh);
  def.unit = massProperties(checked.mesh, 1);
  return def;
}

}  // namespace rigid_body_sim
