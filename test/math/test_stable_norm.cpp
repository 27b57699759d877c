#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <rigid_body_sim/math/rotation.hpp>

namespace rigid_body_sim {
namespace {

TEST(StableNorm, IsTheNormToRoundingAtEverySize) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int exponent = -1000; exponent <= 1000; exponent += 20) {
    const Vector3d v(normal(random), normal(random), normal(random));
    const auto squared = [](double x) { return static_cast<long double>(x) * x; };
    const auto norm =
        static_cast<double>(std::sqrt(squared(v.x()) + squared(v.y()) + squared(v.z())));
    const double scale = std::ldexp(1.0, exponent);
    EXPECT_NEAR(stableNorm(Vector3d(scale * v)) / scale / norm, 1, 1e-15) << exponent;
  }
}

TEST(StableNorm, IsTheNormAtTheEndsOfTheRange) {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  constexpr double kGreatest = std::numeric_limits<double>::max();
  EXPECT_EQ(stableNorm(Vector3d(0, 0, 0)), 0);
  EXPECT_EQ(stableNorm(Vector3d(0, -kLeast, 0)), kLeast);
  // the inverse of the greatest number has 50 bits
  EXPECT_NEAR(stableNorm(Vector3d(0, 0, kGreatest)) / kGreatest, 1, std::ldexp(1, -50));
}

TEST(StableNorm, KeepsWhatIsNotANumber) {
  for (int k = 0; k < 3; ++k) {
    for (const double others : {0.0, 1.0}) {
      Vector3d v(others, others, others);
      v(k) = std::numeric_limits<double>::quiet_NaN();
      EXPECT_TRUE(std::isnan(stableNorm(v))) << k << ' ' << others;
    }
  }
}

}  // namespace
}  // namespace rigid_body_sim
