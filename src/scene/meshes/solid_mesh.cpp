#include "scene/meshes/solid_mesh.hpp"

#include <stdexcept>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/files/file_reference.hpp"
#include "scene/meshes/read_mesh.hpp"

namespace rigid_body_sim {

SolidMesh readSolidMesh(const std::string& path, double scale) {
  const CheckedMesh checked = checkedMesh(readMesh(path, scale));
  if (!checked.fault.empty()) throw std::runtime_error(path + ": " + checked.fault);
  SolidMesh solid;
  solid.def.url = viewerUrl(path, "");
  solid.def.scale = scale;
  solid.def.volume = volume(checked.mesh);
  solid.def.unit = massProperties(checked.mesh, 1);
  if (!checked.notice.empty()) solid.notice = path + ": " + checked.notice;
  return solid;
}

}  // namespace rigid_body_sim
