#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "support/contact_benches.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

/// Lands on one corner after another.
Bench fallingBox() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  BodyFrameMotion motion = motionAt({0, 0, 0.5}, {0.5, 0, 0}, {1, 2, 0.5});
  motion.q_WB = rotationExp(Vector3d(0.3, 0.5, 0.1));
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, motion, test::slope(0), contactOf(1e6, 1.5, 0.2, 0.5));
  return bench;
}

/// Steps for a second; returns when the box touches first [s].
double firstTouch(Simulation& sim) {
  double touch = std::numeric_limits<double>::infinity();
  while (sim.time() < 1) {
    sim.step();
    if (!sim.contactEvents().empty()) touch = std::min(touch, sim.contactEvents()[0].t);
  }
  return touch;
}

TEST(Promise, IsKeptWhereTheErrorStaysBelowTheTolerance) {
  Simulation sim = test::simulationAt(fallingBox(), 1e-6, 0.005);
  sim.trackError();
  EXPECT_LT(firstTouch(sim), 0.5);
  EXPECT_TRUE(std::isinf(sim.errorEstimate().lost_at));
  EXPECT_EQ(describePromise(sim), "");
}

// Impacts magnify what rounding leaves, below which no bound of a step goes.
TEST(Promise, IsWithdrawnFromTheInstantAtWhichTheErrorExceedsTheTolerance) {
  Simulation sim = test::simulationAt(fallingBox(), 1e-14, 0.005);
  sim.trackError();
  const double touch = firstTouch(sim), lost_at = sim.errorEstimate().lost_at;
  EXPECT_GT(lost_at, touch);
  EXPECT_LT(lost_at, 1);
  EXPECT_GT(sim.errorEstimate().attitude, 1e-14);
  EXPECT_NE(describePromise(sim).find("is not certain to be held"), std::string::npos);
}

TEST(Promise, IsMadeAnewByAReset) {
  Simulation sim = test::simulationAt(fallingBox(), 1e-14, 0.005);
  sim.trackError();
  firstTouch(sim);
  sim.reset(true);
  EXPECT_TRUE(std::isinf(sim.errorEstimate().lost_at));
}

}  // namespace
}  // namespace rigid_body_sim
