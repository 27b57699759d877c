#include <random>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/principal_axes.hpp>

namespace rigid_body_sim {

TEST(PrincipalAxes, RebuildTheMatrix) {
  std::mt19937 rng(42);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    Matrix3d A;
    for (int k = 0; k < 9; ++k) A(k) = u(rng);
    const Matrix3d I = A * A.transpose();
    const PrincipalAxes axes = principalAxes(I);
    const Matrix3d rebuilt = axes.R_BP * axes.I.asDiagonal() * axes.R_BP.transpose();
    // a few rotations, each of a few ulp
    EXPECT_LE((rebuilt - I).cwiseAbs().maxCoeff(), 4e-15 * I.cwiseAbs().maxCoeff());
    EXPECT_NEAR(axes.R_BP.determinant(), 1, 1e-14);
    EXPECT_LE(axes.I(0), axes.I(1));
    EXPECT_LE(axes.I(1), axes.I(2));
  }
}

}  // namespace rigid_body_sim
