#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/math/types.hpp>

#include "math/compensated_sum.hpp"

namespace rigid_body_sim {

TEST(CompensatedSum, KeepsWhatTheRunningSumIsTooCoarseToHold) {
  CompensatedSum<double> sum(0);
  sum.add(1);
  for (int i = 0; i < 1000000; ++i) sum.add(1e-17);  // each below half an ulp of 1
  EXPECT_DOUBLE_EQ(sum.value(), 1 + 1e-11);
}

TEST(CompensatedSum, SurvivesATermThatCancels) {
  CompensatedSum<double> sum(0);
  for (const double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
  EXPECT_EQ(sum.value(), 2);
}

TEST(CompensatedSum, OfMatricesIsThatOfTheirCoefficients) {
  CompensatedSum<Vector3d> sum(Vector3d::Zero());
  for (const double x : {1.0, 1e100, 1.0, -1e100}) sum.add({x, 2 * x, -x});
  EXPECT_EQ(sum.value(), Vector3d(2, 4, -2));
}

}  // namespace rigid_body_sim
