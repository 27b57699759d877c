#pragma once

#include <string>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// The solid of a mesh file.
struct SolidMesh {
  MeshDef def;         ///< its url is the file:// of the path
  std::string notice;  ///< the path and what was changed about the orientation; empty when nothing
};

/// Reads (readMesh), checks (checkedMesh) and integrates a mesh file, every length multiplied by
/// scale. Throws std::runtime_error with one line, the path first, for what either refuses.
SolidMesh readSolidMesh(const std::string& path, double scale);

}  // namespace rigid_body_sim
