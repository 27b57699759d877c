#include "mass/welded_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "mass/merged_vertices.hpp"

namespace rigid_body_sim {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t i : cell)
      hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(hash ^ hash >> 32);
  }
};

/// The vertices that stay, found by where they lie.
class Staying {
 public:
  explicit Staying(const Vector3d& tolerance) : tolerance_(tolerance) {}

  /// The nearest one within the tolerance; the vertex itself, which then stays, where there is
  /// none.
  std::uint32_t nearestOrSelf(std::uint32_t vertex, const std::vector<Vector3d>& positions) {
    const Vector3d& x = positions[vertex];
    const Cell low = cellOf(x - tolerance_), high = cellOf(x + tolerance_);
    std::uint32_t nearest = vertex;
    double least = 0;
    Cell cell;
    for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
        for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
          const auto found = cells_.find(cell);
          if (found == cells_.end()) continue;
          for (const std::uint32_t other : found->second) {
            const Vector3d apart = positions[other] - x;
            const bool is_near = (apart.array().abs() <= tolerance_.array()).all();
            if (!is_near || (nearest != vertex && apart.norm() >= least)) continue;
            nearest = other;
            least = apart.norm();
          }
        }
    if (nearest == vertex) cells_[cellOf(x)].push_back(vertex);
    return nearest;
  }

 private:
  /// Cells of eight tolerances: most vertices look into one only.
  Cell cellOf(const Vector3d& x) const {
    Cell cell;
    for (int i = 0; i < 3; ++i)
      cell[static_cast<std::size_t>(i)] =
          static_cast<std::int64_t>(std::floor(x[i] / (8 * tolerance_[i])));
    return cell;
  }

  Vector3d tolerance_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

std::vector<bool> endsOfUnbalancedEdges(const TriangleMesh& mesh, const EdgeUses& edges) {
  std::vector<bool> ends(mesh.vertices.size(), false);
  edges.forEach([&ends](const Edge& edge) {
    if (!isBalanced(edge)) ends[edge.lower] = ends[edge.upper] = true;
  });
  return ends;
}

}  // namespace

WeldedMesh welded(const TriangleMesh& mesh, const EdgeUses& edges, const Vector3d& tolerance) {
  const std::vector<bool> may_move = endsOfUnbalancedEdges(mesh, edges);
  Staying staying(tolerance);
  WeldedMesh result;
  TriangleMesh moved = mesh;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!may_move[v]) continue;
    const std::uint32_t target = staying.nearestOrSelf(v, mesh.vertices);
    if (target == v) continue;
    moved.vertices[v] = mesh.vertices[target];
    ++result.vertices;
    result.distance = std::max(result.distance, (mesh.vertices[v] - mesh.vertices[target]).norm());
  }
  result.mesh = withMergedVertices(moved);
  return result;
}

}  // namespace rigid_body_sim
