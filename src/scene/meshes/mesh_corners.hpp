#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// The corners of the convex hull of a mesh file, or of its oriented bounding box, in the scaled
/// axes of the file (extremePoints). The surface need not be closed. Throws std::runtime_error with
/// one line, the path first, for a file that readMesh or convexHull refuses.
std::vector<Vector3d> meshCorners(const std::string& path, const Vector3d& scale, MeshSolid solid);

}  // namespace rigid_body_sim
