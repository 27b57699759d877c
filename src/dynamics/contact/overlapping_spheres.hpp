#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

struct BoundingSphere {
  Vector3d center = Vector3d::Zero();  ///< [m]
  double radius = 0;                   ///< [m] below zero: it overlaps none; may be infinite
};

/// The pairs of spheres that overlap or touch, as indices, the lower one first, in ascending order.
/// Sweep and prune along the axis on which the spheres lie furthest apart: sorting, and one look at
/// each pair whose extents on that axis overlap.
std::vector<std::pair<std::size_t, std::size_t>> overlappingSpheres(
    const std::vector<BoundingSphere>& spheres);

}  // namespace rigid_body_sim
