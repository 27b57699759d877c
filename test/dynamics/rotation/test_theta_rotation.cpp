#include <cmath>

#include <gtest/gtest.h>

#include "support/free_rotation_errors.hpp"

/// The motion by theta functions beside that by elliptic functions in more digits; a third way, the
/// reference, is that of test_free_top.cpp.
namespace rigid_body_sim {
namespace {

/// Bodies that come as near to the separatrix as ±distance, from 0.3 on.
SpinningBody bodyNear(double distance, Random& random) {
  SpinningBody body = randomSpinningBody(BodyFamily::generic, random);
  // D₂ = m₃² I32/I₃ − m₁² I21/I₁ vanishes where m₃/m₁ is this
  const double ratio =
      std::sqrt((body.I(1) - body.I(0)) / body.I(0) * body.I(2) / (body.I(2) - body.I(1)));
  const double m2 = uniform(random, -0.9, 0.9);
  const double m1 = std::sqrt((1 - m2 * m2) / (1 + ratio * ratio));
  body.L_P = 3 * Vector3d(randomSign(random) * m1, m2,
                          randomSign(random) * ratio * m1 * (1 + randomSign(random) * distance));
  return body;
}

double differenceAt(const SpinningBody& body, double t) {
  using L = long double;
  const Vector3<L> L_P = body.L_P.cast<L>();
  const RotationState<L> exact =
      FreeTop<L>(body.I.cast<L>()).from(body.q_WP.cast<L>(), L_P, body.L_W().cast<L>()).at(L(t));
  const RotationState<double> state = freeRotation(body).at(t);
  const double of_L = (state.L_P - exact.L_P.cast<double>()).norm() / body.L_P.norm();
  return std::max(of_L, double((state.q_WP.coeffs().cast<L>() - exact.q_WP.coeffs()).norm()));
}

TEST(ThetaRotation, TakesMostMotionsAndLeavesThoseNearTheSeparatrix) {
  Random random(1);
  int thetas = 0, near = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto isTheta = [](const SpinningBody& body) {
      return freeRotation(body).asTheta() != nullptr;
    };
    thetas += isTheta(randomSpinningBody(BodyFamily::generic, random)) ? 1 : 0;
    near += isTheta(bodyNear(1e-6, random)) ? 1 : 0;
  }
  EXPECT_GE(thetas, 980);
  EXPECT_EQ(near, 0);
}

TEST(ThetaRotation, IsAsExactUpToWhereItEnds) {
  Random random(2);
  double worst = 0;
  int thetas = 0;
  for (int i = 0; i < 3000; ++i) {
    const SpinningBody body = bodyNear(powerOfTen(random, -3.5, -0.5), random);
    if (!freeRotation(body).asTheta()) continue;
    ++thetas;
    worst = std::max(worst, differenceAt(body, uniform(random, -10, 10) / body.spin()));
  }
  EXPECT_GE(thetas, 1000);
  // some ten roundings of numbers up to 1; measured: 1.7e-15
  EXPECT_LE(worst, 4e-15);
}

TEST(ThetaRotation, KeepsTheDigitsOfSmallComponents) {
  // L_P relative to each of its amplitudes, which are 1e-9 of |L| and less
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    SpinningBody body = randomSpinningBody(BodyFamily::generic, random);
    const int axis = i % 2 == 0 ? 0 : 2;
    const double small = powerOfTen(random, -30, -9);
    body.L_P = Vector3d(small, small, small);
    body.L_P(axis) = 1;
    ASSERT_TRUE(freeRotation(body).asTheta());
    const double t = uniform(random, -10, 10) / body.spin();
    using L = long double;
    const Vector3<L> exact =
        FreeTop<L>(body.I.cast<L>())
            .from(body.q_WP.cast<L>(), body.L_P.cast<L>(), body.L_W().cast<L>())
            .at(L(t))
            .L_P;
    const Vector3d L_P = freeRotation(body).at(t).L_P;
    const double scale = std::max(std::abs(double(exact(1))), std::abs(double(exact(2 - axis))));
    for (int k : {1, 2 - axis}) EXPECT_NEAR(L_P(k) / scale, double(exact(k)) / scale, 1e-14);
  }
}

TEST(ThetaRotation, KeepsThePhaseOverAMillionTurns) {
  // the rate is known to some units of rounding of a wide number, 5e-20 of 6e6 rad each; measured:
  // 3.8e-13
  Random random(4);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const SpinningBody body = randomSpinningBody(BodyFamily::generic, random);
    if (!freeRotation(body).asTheta()) continue;
    worst = std::max(worst, differenceAt(body, 6.28e6 / body.spin()));
  }
  EXPECT_LE(worst, 2e-12);
}

}  // namespace
}  // namespace rigid_body_sim
