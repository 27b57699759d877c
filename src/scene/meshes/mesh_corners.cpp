#include "scene/meshes/mesh_corners.hpp"

#include <stdexcept>

#include "scene/meshes/bounding_box.hpp"
#include "scene/meshes/extreme_points.hpp"
#include "scene/meshes/file_hull.hpp"
#include "scene/meshes/read_mesh.hpp"

namespace rigid_body_sim {

std::vector<Vector3d> meshCorners(const std::string& path, const Vector3d& scale, MeshSolid solid) {
  const FileMesh file = readMesh(path, scale);
  try {
    const TriangleMesh hull = hullOf(file);
    if (solid == MeshSolid::kBox) return boundingBox(hull).vertices;
    return extremePoints(hull, file.rounding.maxCoeff());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rigid_body_sim
