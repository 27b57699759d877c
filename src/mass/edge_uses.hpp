#pragma once

#include <cstddef>
#include <vector>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// A triangle's use of an edge, in one number that sorts: upper vertex, direction, triangle. The
/// lower vertex is that of the list in which the use stands.
using EdgeUse = std::uint64_t;

inline std::uint32_t upperVertex(EdgeUse use) { return static_cast<std::uint32_t>(use >> 33); }
inline bool runsDownwards(EdgeUse use) { return (use >> 32 & 1u) != 0; }
inline std::uint32_t triangleOf(EdgeUse use) { return static_cast<std::uint32_t>(use); }

/// All uses of one edge.
struct Edge {
  std::uint32_t lower, upper;  ///< vertices
  const EdgeUse* begin;
  const EdgeUse* end;

  std::size_t triangles() const { return static_cast<std::size_t>(end - begin); }
};

/// Every edge of a mesh with the triangles that use it. 24 bytes a triangle and 8 a vertex; sorted
/// vertex by vertex, which is several times faster than one sort of all edges.
class EdgeUses {
 public:
  /// At most 2³¹ vertices and 2³² triangles; indices must be in range.
  explicit EdgeUses(const TriangleMesh& mesh);

  /// Calls visit(const Edge&) for each edge, ordered by lower, then upper vertex.
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (std::size_t lower = 0; lower + 1 < first_.size(); ++lower) {
      const EdgeUse* const end = uses_.data() + first_[lower + 1];
      for (const EdgeUse* use = uses_.data() + first_[lower]; use != end;) {
        Edge edge{static_cast<std::uint32_t>(lower), upperVertex(*use), use, use};
        while (edge.end != end && upperVertex(*edge.end) == edge.upper) ++edge.end;
        visit(edge);
        use = edge.end;
      }
    }
  }

 private:
  std::vector<std::size_t> first_;  ///< of each lower vertex, and the end
  std::vector<EdgeUse> uses_;
};

/// How many triangles run along the edge from its upper to its lower vertex.
inline std::size_t downwardUses(const Edge& edge) {
  std::size_t count = 0;
  for (const EdgeUse* use = edge.begin; use != edge.end; ++use) count += runsDownwards(*use);
  return count;
}

/// Whether the edge is used as often one way as the other.
inline bool isBalanced(const Edge& edge) { return 2 * downwardUses(edge) == edge.triangles(); }

}  // namespace rigid_body_sim
