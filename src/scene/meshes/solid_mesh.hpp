#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// The solid of a mesh file, in the scaled axes of the file: reads (readMesh), takes the convex
/// hull or the bounding box of its vertices if that is asked for, checks (checkedMesh) and
/// integrates; its url is the file:// of the path. Adds to the notices what was changed, the path
/// first. Throws std::runtime_error with one line, the path first, for what is refused.
MeshDef readSolidMesh(const std::string& path, const Vector3d& scale, MeshSolid solid,
                      std::vector<std::string>& notices);

}  // namespace rigid_body_sim
