#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "mass/edge_fault.hpp"
#include "mass/merged_vertices.hpp"

namespace rigid_body_sim {
namespace {

std::string vertexFault(const std::vector<Vector3d>& vertices) {
  std::ostringstream fault;
  // an index and a direction are sorted together in 32 bits
  if (vertices.size() > std::numeric_limits<std::int32_t>::max()) {
    fault << "mesh must have at most 2147483647 vertices, got " << vertices.size();
    return fault.str();
  }
  for (const Vector3d& v : vertices) {
    if (v.allFinite()) continue;
    fault << "mesh vertices must be finite, got [" << v.transpose() << "] for vertex "
          << &v - vertices.data();
    break;
  }
  return fault.str();
}

std::string triangleFault(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "mesh must have at least one triangle, got 0";
  std::ostringstream fault;
  for (const Triangle& t : mesh.triangles) {
    const std::uint32_t greatest = std::max({t[0], t[1], t[2]});
    if (greatest < mesh.vertices.size()) continue;
    fault << "mesh triangle " << &t - mesh.triangles.data() << " refers to vertex " << greatest
          << ", but there are " << mesh.vertices.size() << " vertices";
    break;
  }
  return fault.str();
}

double diameter(const std::vector<Vector3d>& vertices) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : vertices) box.extend(v);
  return box.diagonal().norm();
}

double surfaceArea(const TriangleMesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3d& a = mesh.vertices[t[0]];
    const Vector3d along = mesh.vertices[t[1]] - a;
    area += along.cross(mesh.vertices[t[2]] - a).norm() / 2;
  }
  return area;
}

std::string volumeFault(const TriangleMesh& mesh, double mesh_volume) {
  const double area = surfaceArea(mesh);
  // what rounding alone can give a flat mesh: heights off by a few ulp of its size, times its base
  const double rounding =
      4 * std::numeric_limits<double>::epsilon() * diameter(mesh.vertices) * area;
  if (std::isfinite(mesh_volume) && std::abs(mesh_volume) > rounding) return {};
  std::ostringstream fault;
  fault.precision(17);
  fault << "mesh must enclose a volume, got " << mesh_volume << " m^3 within a surface of " << area
        << " m^2";
  return fault.str();
}

std::string turnedAround(TriangleMesh& mesh, double inward_volume) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  std::ostringstream notice;
  notice.precision(17);
  notice << "mesh is oriented inwards (volume " << inward_volume << " m^3): its "
         << mesh.triangles.size() << " triangles are turned around";
  return notice.str();
}

}  // namespace

CheckedMesh checkedMesh(const TriangleMesh& mesh) {
  CheckedMesh checked;
  checked.fault = triangleFault(mesh);
  if (checked.fault.empty()) checked.fault = vertexFault(mesh.vertices);
  if (!checked.fault.empty()) return checked;

  checked.mesh = withMergedVertices(mesh);
  if (checked.mesh.triangles.empty())
    checked.fault = "mesh must have a triangle with three different corners, got 0 of " +
                    std::to_string(mesh.triangles.size());
  else
    checked.fault = edgeFault(checked.mesh);
  if (!checked.fault.empty()) return checked;

  const double mesh_volume = volume(checked.mesh);
  checked.fault = volumeFault(checked.mesh, mesh_volume);
  if (checked.fault.empty() && mesh_volume < 0)
    checked.notice = turnedAround(checked.mesh, mesh_volume);
  return checked;
}

}  // namespace rigid_body_sim
