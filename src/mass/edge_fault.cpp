#include "mass/edge_fault.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

/// Edges that break one rule.
struct Offenders {
  std::size_t edges = 0;
  std::optional<Edge> first;

  void add(const Edge& edge) {
    if (edges++ == 0) first = edge;
  }
};

/// A corner of a triangle that is there twice, the same way round; none where all differ.
std::optional<std::uint32_t> cornerOfDoubled(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  const auto doubled = std::adjacent_find(triangles.begin(), triangles.end());
  if (doubled == triangles.end()) return std::nullopt;
  return doubled->front();
}

/// Edges by the rule that they break.
struct Survey {
  Offenders open, overused, one_way;
  bool shared = false;  ///< an edge, by more than two triangles
};

Survey survey(const EdgeUses& edges) {
  Survey found;
  edges.forEach([&found](const Edge& edge) {
    found.shared |= edge.triangles() > 2;
    if (isBalanced(edge)) return;
    Offenders& offenders = edge.triangles() == 1   ? found.open
                           : edge.triangles() == 2 ? found.one_way
                                                   : found.overused;
    offenders.add(edge);
  });
  return found;
}

std::string placeOf(const TriangleMesh& mesh, const Offenders& offenders) {
  return "from " + shortest(mesh.vertices[offenders.first->lower]) + " to " +
         shortest(mesh.vertices[offenders.first->upper]) + " m";
}

}  // namespace

EdgeFault edgeFault(const TriangleMesh& mesh, const EdgeUses& edges) {
  const Survey found = survey(edges);
  std::ostringstream fault;
  if (found.open.edges > 0)
    fault << "mesh must be closed, got " << found.open.edges << " open edges, the first "
          << placeOf(mesh, found.open);
  else if (found.overused.edges > 0)
    fault << "mesh edges must have as many triangles on one side as on the other, got "
          << found.overused.edges << " that have not, the first with "
          << found.overused.first->triangles() << " triangles " << placeOf(mesh, found.overused);
  else if (found.one_way.edges > 0)
    fault << "mesh must be oriented consistently, got " << found.one_way.edges
          << " edges along which both triangles run the same way, the first "
          << placeOf(mesh, found.one_way);
  else if (found.shared)
    if (const auto corner = cornerOfDoubled(mesh.triangles))
      fault << "mesh triangles must differ, got one twice, with a corner at "
            << shortest(mesh.vertices[*corner]) << " m";
  return {fault.str(), found.open.edges};
}

}  // namespace rigid_body_sim
