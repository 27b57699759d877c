#pragma once

#include <string>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// Says why the edges of a mesh with merged vertices bound no solid, with the number of such edges
/// and where the first lies; empty when every edge is used as often one way as the other, and no
/// triangle is there twice.
/// At most 2³¹ vertices.
std::string edgeFault(const TriangleMesh& mesh);

}  // namespace rigid_body_sim
