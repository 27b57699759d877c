#include "scene/meshes/solid_mesh.hpp"

#include <sstream>
#include <stdexcept>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/files/viewer_url.hpp"
#include "scene/meshes/bounding_box.hpp"
#include "scene/meshes/file_hull.hpp"
#include "scene/meshes/read_mesh.hpp"

namespace rigid_body_sim {
namespace {

const char* const kRemedies =
    "; a scene may take another solid for it, shape: {mesh: {file:, solid: hull}} or solid: box, "
    "or "
    "give mass and inertia, with the mesh as the visual";

TriangleMesh surfaceOf(const FileMesh& file, std::vector<std::string>& notices) {
  CheckedMesh checked = checkedMesh(file.mesh, file.rounding);
  if (!checked.fault.empty()) throw std::runtime_error(checked.fault + kRemedies);
  notices = std::move(checked.notices);
  return std::move(checked.mesh);
}

/// The hull of the vertices that triangles use, or the box around it.
TriangleMesh solidAround(const FileMesh& file, MeshSolid solid, std::vector<std::string>& notices) {
  const TriangleMesh hull = hullOf(file);
  const bool is_hull = solid == MeshSolid::kHull;
  const CheckedMesh checked = checkedMesh(is_hull ? hull : boundingBox(hull));
  if (!checked.fault.empty()) throw std::runtime_error(checked.fault);
  std::ostringstream notice;
  notice << "solid is the " << (is_hull ? "convex hull" : "oriented bounding box")
         << " of the mesh, of " << volume(checked.mesh) << " m^3, in place of its surface";
  notices.push_back(notice.str());
  return checked.mesh;
}

}  // namespace

MeshDef readSolidMesh(const std::string& path, const Vector3d& scale, MeshSolid solid,
                      std::vector<std::string>& notices) {
  const FileMesh file = readMesh(path, scale);
  const std::string where = path + ": ";
  MeshDef def;
  try {
    std::vector<std::string> remarks;
    const TriangleMesh mesh =
        solid == MeshSolid::kSurface ? surfaceOf(file, remarks) : solidAround(file, solid, remarks);
    def.volume = volume(mesh);
    def.unit = massProperties(mesh, 1);
    for (const std::string& remark : remarks) notices.push_back(where + remark);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(where + error.what());
  }
  def.url = viewerUrl(path, "");
  def.scale = scale;
  def.solid = solid;
  return def;
}

}  // namespace rigid_body_sim
