#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/principal_axes.hpp>
#include <rigid_body_sim/math/types.hpp>

#include "support/random_mass.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

/// Greatest entry of R diag(I) Rᵀ − I in ulp of the greatest entry of I. Multiplied out in extended
/// precision, so that the result is judged and not the check.
double residual(const Matrix3d& I, const PrincipalAxes& axes) {
  const Matrix3<long double> R = axes.R_BP.cast<long double>();
  const Matrix3<long double> rebuilt = R * axes.I.cast<long double>().asDiagonal() * R.transpose();
  const long double error = (rebuilt - I.cast<long double>()).cwiseAbs().maxCoeff();
  return static_cast<double>(error) / (kUlp * I.cwiseAbs().maxCoeff());
}

void expectAxesOf(const Matrix3d& I) {
  const PrincipalAxes axes = principalAxes(I);
  // 4 ulp is the claim; 1.3 was measured (13 if the rotations are multiplied up in double)
  EXPECT_LE(residual(I, axes), 4) << I;
  EXPECT_LE((axes.R_BP.transpose() * axes.R_BP - Matrix3d::Identity()).cwiseAbs().maxCoeff(),
            4 * kUlp);
  EXPECT_GT(axes.R_BP.determinant(), 0);
  EXPECT_LE(axes.I(0), axes.I(1));
  EXPECT_LE(axes.I(1), axes.I(2));
}

/// A random matrix with the given principal moments.
Matrix3d turned(const Vector3d& moments, RandomMass& random) {
  const Matrix3d R = random.rotation();
  const Matrix3d I = R * moments.asDiagonal() * R.transpose();
  return (I + I.transpose()) / 2;
}

}  // namespace

TEST(PrincipalAxes, RebuildTheMatrixUpToCondition1e12) {
  RandomMass random(42);
  for (int i = 0; i < 100000; ++i) {
    Vector3d moments;
    for (int k = 0; k < 3; ++k) moments[k] = std::pow(10, random.uniform(-12, 0));
    expectAxesOf(turned(moments, random));
    if (HasFailure()) return;
  }
}

TEST(PrincipalAxes, RebuildDegenerateMatrices) {
  RandomMass random(43);
  for (int i = 0; i < 10000; ++i) {
    const double a = std::pow(10, random.uniform(-12, 0));
    expectAxesOf(turned({1, 1, 1}, random));
    expectAxesOf(turned({1, 1, 1 - a}, random));
    expectAxesOf(turned({a, 1, 1}, random));
    expectAxesOf(turned({a, a, 1}, random));
    expectAxesOf(turned({1, 1 + 1e-15, 1 - 1e-15}, random));
    if (HasFailure()) return;
  }
}

TEST(PrincipalAxes, RebuildMatricesThatAreNotPositive) {
  // massPropertiesFault has to tell their moments
  RandomMass random(44);
  for (int i = 0; i < 1000; ++i) {
    expectAxesOf(turned(random.vector(1), random));
    expectAxesOf(turned({0, 0, random.uniform(-1, 1)}, random));
  }
  expectAxesOf((Matrix3d() << 0, 1, 0, 1, 0, 0, 0, 0, 1).finished());
  EXPECT_EQ(principalAxes(Matrix3d::Zero()).I, Vector3d::Zero());
}

TEST(PrincipalAxes, KeepEachMomentOfAGradedMatrix) {
  // D B D with B well conditioned: the needle's small moment is fixed by the entries to a few ulp
  // of itself. Checked by determinant and sum of minors, which are exact to 1e-18 in extended
  // precision and in which the small moments are factors.
  RandomMass random(45);
  for (int i = 0; i < 10000; ++i) {
    const Matrix3d B = turned({1, 1.5, 2}, random);
    Vector3d scale;
    for (int k = 0; k < 3; ++k) scale[k] = std::pow(10, random.uniform(-6, 0));
    Matrix3d I = scale.asDiagonal() * B * scale.asDiagonal();
    I = ((I + I.transpose()) / 2).eval();
    const Matrix3<long double> M = I.cast<long double>();
    const Vector3d p = principalAxes(I).I;
    const long double minors = M(0, 0) * M(1, 1) - M(0, 1) * M(1, 0) + M(1, 1) * M(2, 2) -
                               M(1, 2) * M(2, 1) + M(0, 0) * M(2, 2) - M(0, 2) * M(2, 0);
    EXPECT_NEAR(p.sum() / I.trace(), 1, 2e-15);
    EXPECT_NEAR((p(0) * p(1) + p(1) * p(2) + p(2) * p(0)) / static_cast<double>(minors), 1, 2e-15);
    EXPECT_NEAR(p.prod() / static_cast<double>(M.determinant()), 1, 2e-15);
    if (HasFailure()) return;
  }
}

TEST(PrincipalAxes, OfADiagonalMatrixAreThoseOfTheBody) {
  const auto axesOf = [](double x, double y, double z) {
    return principalAxes(Vector3d(x, y, z).asDiagonal());
  };
  EXPECT_EQ(axesOf(1, 2, 3).R_BP, Matrix3d::Identity());
  EXPECT_EQ(axesOf(2, 2, 2).R_BP, Matrix3d::Identity());
  EXPECT_EQ(axesOf(1e-12, 1, 1).R_BP, Matrix3d::Identity());
  EXPECT_EQ(axesOf(3, 1, 2).R_BP, (Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished());
  EXPECT_EQ(axesOf(3, 1, 2).I, Vector3d(1, 2, 3));
  // an odd permutation needs one axis turned round
  EXPECT_EQ(axesOf(2, 1, 3).R_BP, (Matrix3d() << 0, 1, 0, 1, 0, 0, 0, 0, -1).finished());
}

TEST(PrincipalAxes, OfAMatrixDiagonalToRoundingAreThoseOfTheBody) {
  Matrix3d I = Vector3d(0.4, 0.4, 0.4).asDiagonal();
  I(0, 1) = I(1, 0) = 4e-17;
  I(1, 2) = I(2, 1) = -3e-17;
  EXPECT_EQ(principalAxes(I).R_BP, Matrix3d::Identity());
}

TEST(PrincipalAxes, AreTheSameBitsEveryTime) {
  RandomMass random(46);
  for (int i = 0; i < 100; ++i) {
    const Matrix3d I = turned({1, 1, 2}, random);
    EXPECT_EQ(principalAxes(I).R_BP, principalAxes(I).R_BP);
    // the moments do not depend on which half of the matrix is read
    EXPECT_EQ(principalAxes(I).I, principalAxes(I.transpose()).I);
  }
}

}  // namespace rigid_body_sim
