#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// A mesh made ready for the integrals, or the reason why it bounds no solid.
struct CheckedMesh {
  TriangleMesh mesh;  ///< vertices merged, oriented outwards; for use when fault is empty
  std::string fault;  ///< the rule that is broken, with the figures; empty when none
  std::vector<std::string> notices;  ///< what was changed, and what counts twice
};

/// Merges vertices at exactly the same position (STL repeats them for every triangle), drops
/// triangles of which two corners are then the same, and checks that the mesh bounds a solid:
///   - at least one triangle, indices within the vertices, finite vertices;
///   - closed: no edge belongs to one triangle only;
///   - no edge belongs to more triangles on one side than on the other (used thrice);
///   - neighbours run along their common edge in opposite directions;
///   - the volume is more than rounding.
///
/// Of a mesh that is open, vertices at its open edges that lie within `rounding` [m] of one another
/// along each axis (and within 1e-5 of the mesh's diameter) are welded, if that closes it; a notice
/// says so. No vertex of a closed mesh moves. Zero: nothing is welded.
///
/// Each shell that lies in no other is turned outwards, and what lies within it is turned with it;
/// a notice says so. So a cavity is a shell within another of the other sense; a notice names
/// shells within one another of the same sense, and shells that overlap, which count twice. Solids
/// that touch along an edge, used as often one way as the other, are accepted: the integrals hold.
/// Not found: a shell that passes through itself, and some overlaps of large shells (nestingOf).
///
/// Time and memory are linear in the triangles (24 bytes each for their edges), but for comparing
/// shells; a mesh of so many that this would take seconds is turned as a whole, with a notice.
CheckedMesh checkedMesh(const TriangleMesh& mesh, const Vector3d& rounding = Vector3d::Zero());

}  // namespace rigid_body_sim
