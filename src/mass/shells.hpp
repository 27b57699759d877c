#pragma once

#include <vector>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

#include "mass/edge_uses.hpp"

namespace rigid_body_sim {

/// A closed surface of its own within a mesh.
struct Shell {
  std::vector<std::uint32_t> triangles;  ///< indices, ascending
  Eigen::AlignedBox3d box;               ///< [m]
  double volume = 0;                     ///< [m³] negative where it is oriented inwards
  bool is_flat = false;                  ///< its volume is no more than rounding
};

/// The shells of a mesh whose edges are balanced, in the order of their first triangles: triangles
/// that are connected by edges of two triangles. Where more meet at an edge, as where two solids
/// touch, they belong together only if they would not be balanced apart. Empty for a mesh that is
/// one shell, the usual case, which so costs no more than finding that out.
std::vector<Shell> shellsOf(const TriangleMesh& mesh, const EdgeUses& edges);

/// Whether a volume [m³] is no more than rounding makes of a flat surface: heights off by a few ulp
/// of its diameter [m], times its area [m²]. Not finite counts as flat.
bool isFlat(double volume, double area, double diameter);

/// [m²]
double area(const TriangleMesh& mesh, const Triangle& t);

}  // namespace rigid_body_sim
