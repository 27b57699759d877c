#pragma once

#include "mass/merged_vertices.hpp"
#include "scene/meshes/convex_hull.hpp"
#include "scene/meshes/file_mesh.hpp"

namespace rigid_body_sim {

/// The convex hull of the vertices that triangles of a file use (convexHull); its thickness must be
/// more than the rounding of the file.
inline TriangleMesh hullOf(const FileMesh& file) {
  return convexHull(withMergedVertices(file.mesh).vertices, file.rounding.maxCoeff());
}

}  // namespace rigid_body_sim
