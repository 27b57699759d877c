#pragma once

#include <string>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

#include "mass/edge_uses.hpp"

namespace rigid_body_sim {

/// What is wrong with the edges of a mesh.
struct EdgeFault {
  std::string text;            ///< with the number of such edges and where the first lies; or empty
  std::size_t open_edges = 0;  ///< edges of one triangle only
};

/// Says why the edges of a mesh with merged vertices bound no solid; no text when every edge is
/// used as often one way as the other, and no triangle is there twice.
EdgeFault edgeFault(const TriangleMesh& mesh, const EdgeUses& edges);

}  // namespace rigid_body_sim
