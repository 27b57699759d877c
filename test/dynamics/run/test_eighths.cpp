#include <cmath>

#include <gtest/gtest.h>

#include "dynamics/run/eighths.hpp"

namespace rigid_body_sim {
namespace {

EighthsInterpolant::Values valuesOf(double (*f)(double, double), double parameter) {
  EighthsInterpolant::Values values;
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = f(static_cast<double>(k), parameter);
  return values;
}

double dip(double x, double at) { return (x - at) * (x - at) * (1 + 0.1 * x) - 0.25; }

// Of a polynomial of degree three nothing is lost but what a parabola through places 1/8 apart
// leaves of x³/10: 0.385 (1/8)³/10 = 8e-5 of the value, (1/8)²/20 = 8e-4 of the place.
TEST(Eighths, ShowAMinimumAnywhereBetweenTheEnds) {
  for (double at : {0.0003, 0.002, 0.03, 0.5, 3.3, 7.9, 7.996, 7.9995}) {
    const auto minima = EighthsInterpolant(valuesOf(dip, at)).minima();
    ASSERT_EQ(minima.size(), 1u) << at;
    EXPECT_NEAR(minima[0].x, at, 8e-4) << at;
    EXPECT_NEAR(minima[0].y, -0.25, 8e-5) << at;
  }
}

TEST(Eighths, HaveNoMinimumAtAnEnd) {
  const auto rising = [](double x, double) { return std::exp(0.3 * x); };
  EXPECT_TRUE(EighthsInterpolant(valuesOf(rising, 0)).minima().empty());
  const auto falling = [](double x, double) { return std::exp(-0.3 * x); };
  EXPECT_TRUE(EighthsInterpolant(valuesOf(falling, 0)).minima().empty());
}

}  // namespace
}  // namespace rigid_body_sim
