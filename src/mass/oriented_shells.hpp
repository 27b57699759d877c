#pragma once

#include <string>
#include <vector>

#include "mass/edge_uses.hpp"

namespace rigid_body_sim {

/// Turns every shell that lies in no other outwards, and with it the shells within. Returns a
/// notice for each thing that the user should see: what was turned; shells within another of the
/// same sense, and shells that overlap, whose common volume counts twice. mesh: balanced edges.
std::vector<std::string> orientShells(TriangleMesh& mesh, const EdgeUses& edges);

}  // namespace rigid_body_sim
