#include <cmath>

#include <gtest/gtest.h>

#include "math/gauss_legendre.hpp"

namespace rigid_body_sim {
namespace {

double integralOfPower(int nodes, int degree) {
  double sum = 0;
  for (const QuadratureNode& node : gaussLegendre(nodes))
    sum += node.weight * std::pow(node.place, degree);
  return sum;
}

}  // namespace

// ∫₀¹ xᵏ dx = 1/(k + 1); the error at k = 2n is n!⁴/((2n + 1) (2n)!²), 3e-12 at n = 10
TEST(GaussLegendre, IsExactUpToDegreeTwoNLessOneAndNotBeyond) {
  for (int n = 1; n <= kMaxGaussNodes; ++n) {
    for (int degree = 0; degree < 2 * n; ++degree)
      EXPECT_NEAR(integralOfPower(n, degree), 1.0 / (degree + 1), 4e-16) << n << ' ' << degree;
    const double central = std::pow(std::tgamma(n + 1.0), 2) / std::tgamma(2 * n + 1.0);
    const double error = 1.0 / (2 * n + 1) - integralOfPower(n, 2 * n);
    EXPECT_NEAR(error, central * central / (2 * n + 1), 4e-16) << n;
  }
}

}  // namespace rigid_body_sim
