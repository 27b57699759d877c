#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/worlds.hpp"

/// What auto does where a motion dies out.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::principalBody;

// A mass of 1 kg on a damped spring, and on a tether that stays taut, comes to rest long before a
// sixteenth of the horizon: what was wrong on the way must be seen there. s = mg/k + e^(−bt) (A cos
// wt + B sin wt), b = c/2, w² = k − b².
TEST(Auto, HoldsItsToleranceWhereTheMotionDiesOutEarly) {
  constexpr double k = 400, c = 8, g = 10, b = c / 2, start = 0.05;
  const double w = std::sqrt(k - b * b), rest = g / k, A = start - rest, B = b * A / w;
  for (bool on_spring : {true, false}) {
    for (double horizon : {10.0, 100.0}) {
      Bench bench;
      bench.world.g_W = {0, 0, -g};
      BodyFrameMotion motion;
      motion.x_W.z() = -1 - start;
      bench.add(principalBody("ball", 1, {0.004, 0.004, 0.004}), motion);
      const Spring::End above{kWorld, {0, 0, 0}}, ball{0, {0, 0, 0}};
      if (on_spring)
        bench.addSpring(above, ball, {k, c, 1});
      else
        bench.world.laws.push_back(
            std::make_shared<Tether>(above, ball, Tether::Constants{k, c, 1}));
      bench.world.solver.tolerance = 1e-6;
      bench.world.solver.tolerance_stated = true;
      bench.world.solver.horizon = horizon;
      Simulation sim = bench.simulation("auto", 0.005);
      while (sim.time() < 4) {
        sim.step();
        const double t = sim.time();
        const double s = rest + std::exp(-b * t) * (A * std::cos(w * t) + B * std::sin(w * t));
        // of the path, which is 0.05 m and more
        ASSERT_NEAR(sim.body(0).x_W.z(), -1 - s, 5e-8) << on_spring << ", " << horizon << ", " << t;
      }
    }
  }
}

// Below the rounding of a momentum no estimate comes: steps that wait for it end nowhere.
TEST(Auto, CostsNoMoreAtRestUnderALongHorizon) {
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  BodyFrameMotion motion;
  motion.x_W.z() = -0.8;
  bench.add(principalBody("ball", 1, {0.004, 0.004, 0.004}), motion);
  bench.world.laws.push_back(std::make_shared<Tether>(
      Spring::End{kWorld, {0, 0, 0}}, Spring::End{0, {0, 0, 0}}, Tether::Constants{400, 8, 1}));
  bench.world.solver.horizon = 600;
  Simulation sim = bench.simulation("auto", 0.001);
  std::int64_t before = 0;
  while (sim.time() < 4) {
    if (sim.steps() == 3000) before = sim.evaluations();
    sim.step();
  }
  EXPECT_LT(sim.evaluations() - before, 10 * 12 * 1000);  // ten substeps of twelve stages each
}

}  // namespace
}  // namespace rigid_body_sim
