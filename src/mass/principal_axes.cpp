#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Jacobi>

#include <rigid_body_sim/mass/principal_axes.hpp>

namespace rigid_body_sim {
namespace {

/// Columns of R reordered so that the moments ascend; one column turned round where that keeps R
/// right-handed.
PrincipalAxes ascending(const Vector3d& I, const Matrix3d& R) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return I(a) < I(b); });
  PrincipalAxes axes;
  for (int k = 0; k < 3; ++k) {
    axes.I(k) = I(order[static_cast<std::size_t>(k)]);
    axes.R_BP.col(k) = R.col(order[static_cast<std::size_t>(k)]);
  }
  if (axes.R_BP.determinant() < 0) axes.R_BP.col(2) *= -1;
  return axes;
}

}  // namespace

PrincipalAxes principalAxes(const Matrix3d& symmetric) {
  Matrix3d D = symmetric;
  Matrix3d R = Matrix3d::Identity();
  constexpr int kMaxSweeps = 60;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    bool rotated = false;
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      // an off-diagonal entry below rounding of its own two diagonal entries turns nothing
      if (std::abs(D(p, q)) <= 1e-17 * std::sqrt(std::abs(D(p, p)) * std::abs(D(q, q)))) continue;
      Eigen::JacobiRotation<double> J;
      J.makeJacobi(D, p, q);
      D.applyOnTheLeft(p, q, J.adjoint());
      D.applyOnTheRight(p, q, J);
      D(p, q) = D(q, p) = 0;
      R.applyOnTheRight(p, q, J);
      rotated = true;
    }
    if (!rotated) break;
  }
  return ascending(D.diagonal(), R);
}

}  // namespace rigid_body_sim
