#pragma once

#include <rigid_body_sim/mass/triangle_mesh.hpp>

#include "mass/edge_uses.hpp"

namespace rigid_body_sim {

/// A mesh some of whose vertices were welded.
struct WeldedMesh {
  TriangleMesh mesh;
  std::size_t vertices = 0;  ///< how many were moved onto another
  double distance = 0;       ///< [m] the farthest that one was moved
};

/// Welds vertices at the ends of unbalanced edges that lie within the tolerance [m] of one another
/// along each axis: in the order of the vertices, each goes to the nearest that stayed, or stays.
/// None of them is moved twice, so that no chain of near vertices collapses. Everything else, above
/// all each closed shell, keeps its vertices. Triangles two of whose corners then coincide are
/// dropped.
WeldedMesh welded(const TriangleMesh& mesh, const EdgeUses& edges, const Vector3d& tolerance);

}  // namespace rigid_body_sim
