#pragma once

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// I = R_BP diag(I) R_BPᵀ: a symmetric matrix in its own axes.
struct PrincipalAxes {
  Vector3d I;     ///< principal moments, ascending; in the unit of the matrix
  Matrix3d R_BP;  ///< columns: the principal axes in B; a rotation (right-handed)
};

/// Diagonalises a symmetric 3×3 matrix by cyclic Jacobi rotations. A matrix that is already
/// diagonal to rounding keeps its axes up to their order (and the sign that keeps them
/// right-handed). Deterministic.
///
/// Accuracy: R_BP diag(I) R_BPᵀ is within 4 ulp of the greatest entry of the matrix, and the
/// moments of a graded matrix (a needle along an axis) are each right to a few ulp of their own
/// (Demmel & Veselić 1992). Of the halves of a matrix that is not quite symmetric, the mean counts.
/// Source: Rotenberg, "Rigid Body Motion", symmetric Jacobi; Golub & Van Loan, 4th ed., 8.5.
PrincipalAxes principalAxes(const Matrix3d& symmetric);

}  // namespace rigid_body_sim
