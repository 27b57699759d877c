#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "math/small_angle.hpp"

namespace rigid_body_sim {
namespace {

constexpr long double kUlpAtOne = 0x1p-52L;

TEST(SmallAngle, SineAndCosineAreWithinAnUlp) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> square(0, kSmallAngleSquared);
  for (int i = 0; i < 20000; ++i) {
    const double z = square(random);
    const long double x = std::sqrt(static_cast<long double>(z));
    EXPECT_LE(std::abs(sinOverAngle(z) - std::sin(x) / x), kUlpAtOne) << z;
    EXPECT_LE(std::abs(cosine(z) - std::cos(x)), kUlpAtOne) << z;
  }
}

TEST(SmallAngle, NoAngleIsNoTurn) {
  for (double square : {0.0, 1e-320, 1e-40}) {
    EXPECT_EQ(sinOverAngle(square), 1);
    EXPECT_EQ(cosine(square), 1);
  }
}

TEST(SmallAngle, HoldsUpToAnEighthOfATurn) {
  EXPECT_NEAR(std::sqrt(kSmallAngleSquared), std::atan(1.0), 1e-15);
  EXPECT_NEAR(cosine(kSmallAngleSquared), std::sqrt(0.5), 2e-16);
}

}  // namespace
}  // namespace rigid_body_sim
