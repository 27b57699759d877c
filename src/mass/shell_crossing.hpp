#pragma once

#include "mass/shells.hpp"

namespace rigid_body_sim {

/// Pairs of triangles, of one shell each, that lie within both boxes.
struct CommonTriangles {
  std::vector<std::uint32_t> a, b;

  std::size_t pairs() const { return a.size() * b.size(); }
};
CommonTriangles commonTriangles(const TriangleMesh& mesh, const Shell& a, const Shell& b);

/// Whether an edge of one passes through a triangle of the other, by more than the tolerance [m] on
/// either side; what only touches does not.
bool cross(const TriangleMesh& mesh, const CommonTriangles& common, double tolerance);

}  // namespace rigid_body_sim
