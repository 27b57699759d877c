#pragma once

#include <vector>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// The convex hull of points: a closed mesh, oriented outwards, whose vertices are the points at
/// its corners, to the bit and in their order. By Qhull (Barber, Dobkin & Huhdanpaa 1996), which
/// merges facets that differ by rounding.
///
/// Throws std::runtime_error with one line for points at one place, on a line or in a plane, to
/// within `thickness` [m] or what rounding can tell.
TriangleMesh convexHull(const std::vector<Vector3d>& points, double thickness);

}  // namespace rigid_body_sim
