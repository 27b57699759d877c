#pragma once

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// I = R_BP diag(I) R_BPᵀ: a symmetric matrix in its own axes.
struct PrincipalAxes {
  Vector3d I;     ///< principal moments, ascending
  Matrix3d R_BP;  ///< columns: the principal axes in B; a rotation (right-handed)
};

/// Diagonalises a symmetric 3×3 matrix by cyclic Jacobi rotations. A matrix that is already
/// diagonal to rounding keeps its axes up to their order. Deterministic.
/// Source: Rotenberg, "Rigid Body Motion", symmetric Jacobi; Golub & Van Loan, 4th ed., 8.5.
PrincipalAxes principalAxes(const Matrix3d& symmetric);

}  // namespace rigid_body_sim
