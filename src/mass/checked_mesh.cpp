#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "mass/edge_fault.hpp"
#include "mass/merged_vertices.hpp"
#include "mass/oriented_shells.hpp"
#include "mass/shells.hpp"
#include "mass/welded_vertices.hpp"
#include "math/shortest.hpp"

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
    fault << "mesh vertices must be finite, got " << shortest(v) << " for vertex "
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
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += area(mesh, t);
  return sum;
}

std::string volumeFault(const TriangleMesh& mesh) {
  const double mesh_volume = volume(mesh), mesh_area = surfaceArea(mesh);
  if (mesh_volume > 0 && !isFlat(mesh_volume, mesh_area, diameter(mesh.vertices))) return {};
  std::ostringstream fault;
  if (!std::isfinite(mesh_volume) || !std::isfinite(mesh_area))
    return "mesh must have a volume and a surface that are finite numbers; a smaller scale is "
           "needed";
  fault << "mesh must enclose a volume, got " << shortest(mesh_volume)
        << " m^3 within a surface of " << shortest(mesh_area) << " m^2";
  return fault.str();
}

/// How far vertices are welded at most: the rounding, but no more than a hundred-thousandth of the
/// mesh, so that coarse numbers join nothing that one can see. Zero where that is less than the
/// vertices themselves can resolve.
Vector3d weldTolerance(const TriangleMesh& mesh, const Vector3d& rounding) {
  const Vector3d tolerance = rounding.cwiseMin(1e-5 * diameter(mesh.vertices));
  double largest = 0;
  for (const Vector3d& v : mesh.vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  const double resolved = std::numeric_limits<double>::epsilon() * largest;
  return tolerance.minCoeff() > resolved ? tolerance : Vector3d::Zero();
}

std::string weldNotice(const WeldedMesh& weld, std::size_t open_edges, const Vector3d& tolerance) {
  std::ostringstream notice;
  notice << "mesh has " << open_edges << " open edges, and is closed: of its vertices, "
         << weld.vertices << " are welded to others at most " << weld.distance
         << " m away, within the rounding of the file's numbers (" << tolerance.maxCoeff() << " m)";
  return notice.str();
}

/// Checks the edges; welds vertices where the mesh is open and closes by it.
void closeEdges(CheckedMesh& checked, EdgeUses& edges, const Vector3d& rounding) {
  const EdgeFault fault = edgeFault(checked.mesh, edges);
  checked.fault = fault.text;
  if (fault.open_edges == 0) return;
  const Vector3d tolerance = weldTolerance(checked.mesh, rounding);
  if (tolerance.isZero(0)) return;
  WeldedMesh weld = welded(checked.mesh, edges, tolerance);
  if (weld.vertices == 0 || weld.mesh.triangles.empty()) return;
  EdgeUses welded_edges(weld.mesh);
  checked.fault = edgeFault(weld.mesh, welded_edges).text;
  if (!checked.fault.empty()) return;
  checked.notices.push_back(weldNotice(weld, fault.open_edges, tolerance));
  checked.mesh = std::move(weld.mesh);
  edges = std::move(welded_edges);
}

}  // namespace

CheckedMesh checkedMesh(const TriangleMesh& mesh, const Vector3d& rounding) {
  CheckedMesh checked;
  checked.fault = triangleFault(mesh);
  if (checked.fault.empty()) checked.fault = vertexFault(mesh.vertices);
  if (!checked.fault.empty()) return checked;

  checked.mesh = withMergedVertices(mesh);
  if (checked.mesh.triangles.empty()) {
    checked.fault = "mesh must have a triangle with three different corners, got 0 of " +
                    std::to_string(mesh.triangles.size());
    return checked;
  }
  EdgeUses edges(checked.mesh);
  closeEdges(checked, edges, rounding);
  if (!checked.fault.empty()) return checked;

  for (std::string& notice : orientShells(checked.mesh, edges))
    checked.notices.push_back(std::move(notice));
  checked.fault = volumeFault(checked.mesh);
  return checked;
}

}  // namespace rigid_body_sim
