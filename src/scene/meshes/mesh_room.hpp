#pragma once

#include <stdexcept>
#include <string>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

#include "scene/limits.hpp"

namespace rigid_body_sim {

/// Throws std::runtime_error, one line, where a mesh has as many triangles as it may have.
inline void requireRoom(const TriangleMesh& mesh) {
  if (mesh.triangles.size() >= kMaxTriangles)
    throw std::runtime_error("mesh must have at most " + std::to_string(kMaxTriangles) +
                             " triangles");
}

}  // namespace rigid_body_sim
