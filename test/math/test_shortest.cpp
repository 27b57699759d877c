#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "math/shortest.hpp"

namespace rigid_body_sim {

TEST(Shortest, WritesNoDigitsThatNobodyTyped) {
  EXPECT_EQ(shortest(0.03), "0.03");
  EXPECT_EQ(shortest(-1), "-1");
  EXPECT_EQ(shortest(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(shortest(1e300), "1e+300");
  EXPECT_EQ(shortest(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Shortest, WritesAVectorWithoutPadding) {
  EXPECT_EQ(shortest(Vector3d(0.1, -2, 1e-9)), "[0.1 -2 1e-09]");
}

TEST(Shortest, ReadsBackAsTheSameNumber) {
  std::mt19937_64 bits(5);
  for (int i = 0; i < 10000; ++i) {
    const double x =
        std::ldexp(static_cast<double>(bits()), static_cast<int>(bits() % 2000) - 1040);
    EXPECT_EQ(std::strtod(shortest(x).c_str(), nullptr), x);
  }
}

}  // namespace rigid_body_sim
