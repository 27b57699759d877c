#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "mass/shells.hpp"

namespace rigid_body_sim {

/// How the shells of a mesh lie to one another.
struct ShellNesting {
  /// For each shell the smallest that it lies in, which is larger than itself.
  std::vector<std::optional<std::size_t>> within;
  std::size_t overlaps = 0;                           ///< pairs of shells that overlap
  std::pair<std::size_t, std::size_t> first_overlap;  ///< where there is one
  bool is_complete = true;  ///< false: to compare so many would take too long; all else is unset
};

/// Compares all shells whose boxes overlap, except flat ones. A shell lies in another that winds
/// about middles of its triangles, 2 to 32 of them. Two overlap where some of these lie inside and
/// others outside, or where an edge passes through a triangle; edges are looked at where they are
/// few enough (4·10⁶ pairs of triangles). What is not found: an overlap of large shells that none
/// of these points shows.
ShellNesting nestingOf(const TriangleMesh& mesh, const std::vector<Shell>& shells);

/// How often a shell winds about a point that is not on it: 1 within a shell oriented outwards, −1
/// within one oriented inwards, 0 outside of either; on a face ±1/2. The sum of the solid angles of
/// its triangles (van Oosterom & Strackee 1983), over 4π.
double windingNumber(const TriangleMesh& mesh, const Shell& shell, const Vector3d& point);

}  // namespace rigid_body_sim
