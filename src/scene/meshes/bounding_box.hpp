#pragma once

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// A small oriented box around a convex hull, as a closed mesh. Of all boxes with one face along a
/// facet of the hull (its 200 largest, fewer for hulls of more than 10 000 vertices) the smallest,
/// then turned about each of its axes to the smallest there, until it shrinks no more. That is the
/// smallest box of all for boxes, prisms and cylinders; for others it need not be, but every
/// vertex lies in it.
TriangleMesh boundingBox(const TriangleMesh& hull);

}  // namespace rigid_body_sim
