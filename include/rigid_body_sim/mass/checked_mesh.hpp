#pragma once

#include <string>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// A mesh made ready for the integrals, or the reason why it bounds no solid.
struct CheckedMesh {
  TriangleMesh mesh;   ///< vertices merged, oriented outwards; for use when fault is empty
  std::string fault;   ///< the rule that is broken, with the figures; empty when none
  std::string notice;  ///< what was changed about the orientation; empty when nothing
};

/// Merges vertices at exactly the same position (STL repeats them for every triangle), drops
/// triangles that have shrunk to an edge or a point by it, and checks that the mesh bounds a solid:
///   - at least one triangle, indices within the vertices, finite vertices;
///   - closed: no edge belongs to one triangle only;
///   - no edge belongs to more triangles on one side than on the other (used thrice);
///   - neighbours run along their common edge in opposite directions;
///   - the volume is more than rounding.
/// A mesh that is closed and consistent but oriented inwards is turned around, with a notice.
/// Shells with cavities pass unchanged: their total volume is positive. So do solids that touch
/// along an edge, whose edge is used as often one way as the other: the integrals hold.
/// Not found: surfaces that pass through each other, and a component that should not be a cavity.
/// Time and memory are linear in the triangles but for one sort of their edges (24 bytes each).
CheckedMesh checkedMesh(const TriangleMesh& mesh);

}  // namespace rigid_body_sim
