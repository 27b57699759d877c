#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/math/hat.hpp>
#include <rigid_body_sim/math/rotation.hpp>

#include "support/random_mass.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

/// Attitude after turning with constant w for t from A.
Matrix3d turnedBy(const Vector3d& w, double t, const Matrix3d& A) {
  return rotationExp<double>(t * w).toRotationMatrix() * A;
}

}  // namespace

TEST(Hat, IsTheCrossProductAsAMatrix) {
  RandomMass random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d a = random.vector(5), b = random.vector(5);
    // two products a coefficient; the sum with an exact zero costs nothing
    EXPECT_LE((hat(a) * b - a.cross(b)).norm(), 4 * kUlp * a.norm() * b.norm());
  }
}

TEST(Hat, IsSkewSymmetricAndLinear) {
  RandomMass random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d a = random.vector(5), b = random.vector(5);
    EXPECT_EQ(Matrix3d(hat(a).transpose()), Matrix3d(-hat(a)));
    EXPECT_EQ(hat(Vector3d(2 * a + b)), Matrix3d(2 * hat(a) + hat(b)));
    EXPECT_LE((hat(a) * a).norm(), 4 * kUlp * a.squaredNorm());
  }
}

TEST(Hat, SquaredIsTheOuterProductLessTheSquare) {
  // hat(a) hat(a) = a aᵀ − a·a 1, the kernel of every inertia
  RandomMass random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d a = random.vector(5);
    const Matrix3d expected = a * a.transpose() - a.squaredNorm() * Matrix3d::Identity();
    EXPECT_LE((hat(a) * hat(a) - expected).cwiseAbs().maxCoeff(), 4 * kUlp * a.squaredNorm());
  }
}

TEST(Hat, TurnsWithTheBody) {
  // hat(R a) = R hat(a) Rᵀ
  RandomMass random(4);
  for (int i = 0; i < 1000; ++i) {
    const Matrix3d R = random.rotation();
    const Vector3d a = random.vector(5);
    EXPECT_LE((hat(Vector3d(R * a)) - R * hat(a) * R.transpose()).cwiseAbs().maxCoeff(),
              10 * kUlp * a.norm());
  }
}

TEST(RotatingMatrixRate, IsTheDerivativeOfTheAttitude) {
  RandomMass random(5);
  for (int i = 0; i < 100; ++i) {
    const Matrix3d A = random.rotation();
    const Vector3d w = random.vector(1);
    const double h = 1e-5;
    const Matrix3d difference = (turnedBy(w, h, A) - turnedBy(w, -h, A)) / (2 * h);
    // central difference: |w|³ h²/6 < 1e-10 of truncation, ulp/h = 2e-11 of rounding
    EXPECT_LE((difference - rotatingMatrixRate(w, A)).cwiseAbs().maxCoeff(), 2e-10);
  }
}

TEST(RotatingInertiaRate, IsTheDerivativeOfTheWorldInertia) {
  RandomMass random(6);
  for (int i = 0; i < 100; ++i) {
    const Matrix3d A = random.rotation();
    const Matrix3d I_0 = Vector3d(1, 2, 2.5).asDiagonal();
    const Vector3d w = random.vector(1);
    const auto inertiaAt = [&](double t) {
      const Matrix3d A_t = turnedBy(w, t, A);
      return Matrix3d(A_t * I_0 * A_t.transpose());
    };
    const double h = 1e-5;
    const Matrix3d difference = (inertiaAt(h) - inertiaAt(-h)) / (2 * h);
    // as above, with derivatives of I up to 8 |w|³ times its spread of 1.5
    EXPECT_LE((difference - rotatingInertiaRate(w, inertiaAt(0))).cwiseAbs().maxCoeff(), 2e-9);
  }
}

}  // namespace rigid_body_sim
