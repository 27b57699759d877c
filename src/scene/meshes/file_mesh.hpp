#pragma once

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// The surface that a mesh file holds.
struct FileMesh {
  TriangleMesh mesh;
  Vector3d rounding = Vector3d::Zero();  ///< [m] along each axis; see NumberPrecision
};

}  // namespace rigid_body_sim
