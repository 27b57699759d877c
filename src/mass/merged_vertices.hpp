#pragma once

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// The same mesh with every position stored once, in the order of first use (−0 and 0 are the same
/// position), and without triangles two of whose corners coincide. Indices must be in range.
TriangleMesh withMergedVertices(const TriangleMesh& mesh);

}  // namespace rigid_body_sim
