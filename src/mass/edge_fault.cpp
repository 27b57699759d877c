#include "mass/edge_fault.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

namespace rigid_body_sim {
namespace {

/// A triangle's use of an edge, in one number that sorts: lower vertex, upper vertex, direction.
using EdgeUse = std::uint64_t;

EdgeUse edgeUse(std::uint32_t from, std::uint32_t to) {
  const std::uint64_t lower = std::min(from, to), upper = std::max(from, to);
  return lower << 32 | upper << 1 | (from > to ? 1u : 0u);
}
std::size_t lowerVertex(EdgeUse use) { return use >> 32; }
std::size_t upperVertex(EdgeUse use) { return (use & 0xffffffffu) >> 1; }

std::vector<EdgeUse> sortedEdgeUses(const std::vector<Triangle>& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    uses.push_back(edgeUse(t[0], t[1]));
    uses.push_back(edgeUse(t[1], t[2]));
    uses.push_back(edgeUse(t[2], t[0]));
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

/// Edges that break one rule.
struct Offenders {
  std::size_t edges = 0;
  EdgeUse first = 0;
  std::size_t triangles_at_first = 0;

  void add(EdgeUse use, std::size_t triangles) {
    if (edges++ > 0) return;
    first = use;
    triangles_at_first = triangles;
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

}  // namespace

std::string edgeFault(const TriangleMesh& mesh) {
  const std::vector<EdgeUse> uses = sortedEdgeUses(mesh.triangles);
  Offenders open, overused, one_way;
  bool shared = false;  // an edge, by more than two triangles
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    std::size_t backward = 0;
    for (; end < uses.size() && uses[end] >> 1 == uses[begin] >> 1; ++end)
      backward += uses[end] & 1u;
    const std::size_t triangles = end - begin;
    shared |= triangles > 2;
    if (2 * backward == triangles) continue;
    (triangles == 1 ? open : triangles == 2 ? one_way : overused).add(uses[begin], triangles);
  }

  std::ostringstream fault;
  fault.precision(17);
  const auto place = [&](const Offenders& o) {
    std::ostringstream text;
    text.precision(17);
    text << "from [" << mesh.vertices[lowerVertex(o.first)].transpose() << "] to ["
         << mesh.vertices[upperVertex(o.first)].transpose() << "] m";
    return text.str();
  };
  if (open.edges > 0)
    fault << "mesh must be closed, got " << open.edges << " open edges, the first " << place(open);
  else if (overused.edges > 0)
    fault << "mesh edges must have as many triangles on one side as on the other, got "
          << overused.edges << " that have not, the first with " << overused.triangles_at_first
          << " triangles " << place(overused);
  else if (one_way.edges > 0)
    fault << "mesh must be oriented consistently, got " << one_way.edges
          << " edges along which both triangles run the same way, the first " << place(one_way);
  else if (shared)
    if (const auto corner = cornerOfDoubled(mesh.triangles))
      fault << "mesh triangles must differ, got one twice, with a corner at ["
            << mesh.vertices[*corner].transpose() << "] m";
  return fault.str();
}

}  // namespace rigid_body_sim
