#pragma once

#include <vector>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// The vertices of a convex hull that lie between no others: without those that stand out by at
/// most `rounding` [m] above the plane through their neighbours that is normal to the mean of the
/// facets around them, as the vertices within the flat faces and along the straight edges of a
/// tessellated solid do. A rim that is finer than the rounding is thinned out round by round, by up
/// to some twenty times the rounding. In the order of the hull.
std::vector<Vector3d> extremePoints(const TriangleMesh& hull, double rounding);

}  // namespace rigid_body_sim
