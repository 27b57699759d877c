#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "support/worlds.hpp"

/// What an integrator makes of a rod that turns, end over end, with a trace of spin about its
/// length.
namespace rigid_body_sim {
namespace {

constexpr double kTrace = 1e-6;  // [rad/s]

Simulation turnedRod(const std::string& integrator, double duration, double trace = kTrace) {
  test::Bench bench;
  bench.add(test::principalBody("rod", 1, {0.01, 1, 1}), test::tumbling({0, 0, 0}, {trace, 0, 2}));
  Simulation sim = bench.simulation(integrator, 1e-3);
  while (sim.time() < duration) sim.step();
  return sim;
}

}  // namespace

// ½ h (ω·L/I₁ − |ω|²) = ½ 1e-3 (4/0.01 − 4) 1/s
TEST(LeastAxis, IsFedAtTheRateThatAMethodClaims) {
  for (const Method& method : catalogue()) {
    const Simulation sim = turnedRod(method.name, 10);
    const double grown = std::log(sim.body(0).L_P[0] / (0.01 * kTrace));
    const bool claims = method.claimsTo(kFeedsLeastAxis);
    EXPECT_NEAR(sim.magnification(), claims ? 1.98 : 0, 1e-3) << method.name;
    EXPECT_NEAR(grown, sim.magnification(), 0.01) << method.name;
  }
}

TEST(LeastAxis, IsSpokenOfWhereItHasGrownByHalfOfTheDigits) {
  EXPECT_EQ(describeMagnification(turnedRod("semi_implicit_euler", 90, 1e-16)), "");
  EXPECT_EQ(describeMagnification(turnedRod("strang", 100, 1e-16)), "");
  EXPECT_EQ(describeMagnification(turnedRod("semi_implicit_euler", 100, 1e-16)),
            "semi_implicit_euler has magnified what a body turns about its axis of least inertia "
            "10^9 times, rounding, too, so that the motion may be wrong: take another integrator, "
            "or a far smaller time_step");
}

}  // namespace rigid_body_sim
