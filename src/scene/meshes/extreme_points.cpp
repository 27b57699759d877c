#include "scene/meshes/extreme_points.hpp"

#include <algorithm>
#include <limits>

#include "scene/meshes/convex_hull.hpp"

namespace rigid_body_sim {
namespace {

/// Sum of the unit normals of the facets around each vertex. Facets without area have none.
std::vector<Vector3d> vertexNormals(const TriangleMesh& hull) {
  std::vector<Vector3d> normals(hull.vertices.size(), Vector3d::Zero());
  for (const Triangle& t : hull.triangles) {
    const Vector3d& a = hull.vertices[t[0]];
    const Vector3d normal =
        (hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a).stableNormalized();
    for (const std::uint32_t corner : t) normals[corner] += normal;
  }
  return normals;
}

/// [m] How far each vertex stands out above its neighbours, along its normal.
std::vector<double> heights(const TriangleMesh& hull) {
  const std::vector<Vector3d> normals = vertexNormals(hull);
  std::vector<double> heights(hull.vertices.size(), std::numeric_limits<double>::infinity());
  for (const Triangle& t : hull.triangles)
    for (const std::uint32_t v : t)
      for (const std::uint32_t neighbour : t) {
        if (neighbour == v) continue;
        const double height =
            normals[v].stableNormalized().dot(hull.vertices[v] - hull.vertices[neighbour]);
        heights[v] = std::min(heights[v], height);
      }
  return heights;
}

/// The vertices but those that stand out by no more than `rounding`. Of two neighbours one stays,
/// so that a fine rim is thinned out and never removed as a whole.
std::vector<Vector3d> withoutLowest(const TriangleMesh& hull, double rounding) {
  const std::vector<double> height = heights(hull);
  std::vector<bool> removed(height.size()), stays(height.size());
  std::vector<std::vector<std::uint32_t>> neighbours(height.size());
  for (const Triangle& t : hull.triangles)
    for (std::size_t i = 0; i < 3; ++i) neighbours[t[i]].push_back(t[(i + 1) % 3]);
  std::vector<Vector3d> kept;
  for (std::size_t v = 0; v < height.size(); ++v) {
    removed[v] = height[v] <= rounding && !stays[v];
    if (!removed[v]) kept.push_back(hull.vertices[v]);
    for (const std::uint32_t neighbour : neighbours[v])
      if (removed[v]) stays[neighbour] = true;
  }
  return kept;
}

}  // namespace

std::vector<Vector3d> extremePoints(const TriangleMesh& hull, double rounding) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : hull.vertices) box.extend(p);
  const double least = std::max(rounding, 1e-12 * box.diagonal().norm());
  TriangleMesh rest = hull;
  while (true) {
    std::vector<Vector3d> kept = withoutLowest(rest, least);
    if (kept.size() == rest.vertices.size()) return kept;
    rest = convexHull(kept, least);
  }
}

}  // namespace rigid_body_sim
