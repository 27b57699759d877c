#include "scene/meshes/solid_mesh.hpp"

#include <stdexcept>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/files/file_reference.hpp"
#include "scene/meshes/read_mesh.hpp"

namespace rigid_body_sim {

MeshDef readSolidMesh(const std::string& path, double scale, std::vector<std::string>& notices) {
  const FileMesh file = readMesh(path, Vector3d::Constant(scale));
  const CheckedMesh checked = checkedMesh(file.mesh, file.rounding);
  if (!checked.fault.empty()) throw std::runtime_error(path + ": " + checked.fault);
  for (const std::string& notice : checked.notices) notices.push_back(path + ": " + notice);
  MeshDef def;
  def.url = viewerUrl(path, "");
  def.scale = scale;
  def.volume = volume(checked.mesh);
  def.unit = massProperties(checked.mesh, 1);
  return def;
}

}  // namespace rigid_body_sim
