#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "support/method_cases.hpp"

namespace rigid_body_sim {
namespace {

using namespace test;  // cases and benches

TEST(Auto, HoldsItsToleranceForEveryKindOfWrench) {
  for (double tolerance : {1e-3, 1e-6, 1e-9}) {
    for (Case c : allCases()) {
      c.bench.world.solver.tolerance = tolerance;
      c.bench.world.solver.horizon = 2;
      const reference::Motions truth = test::referenceRun(c.bench, 2);
      const auto errors = test::motionErrors(c.bench.run("auto", 2, 100), truth);
      EXPECT_LT(errors.attitude, tolerance) << c.name;
      EXPECT_LT(errors.position, tolerance * 20) << c.name;  // [m] the box falls 20 m
    }
  }
}

TEST(Auto, SolvesWhatCanBeSolvedAndChoosesARowForTheRest) {
  for (Case c : allCases()) {
    c.bench.world.solver.horizon = 2;
    const Simulation sim = c.bench.simulation("auto", 0.01);
    EXPECT_EQ(sim.groups()[0].choice().method == nullptr, needsOf(c) == 0) << c.name;
    EXPECT_TRUE(sim.groups()[0].choice().holds) << c.name;
  }
}

TEST(Taylor, RefusesAWrenchThatTurnsWithAnotherBody) {
  try {
    coupledBodies().simulation("taylor", 0.01);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string(refused.what()).find("'box'"), std::string::npos) << refused.what();
  }
  Simulation sim = freeBody().simulation("taylor", 0.01);
  PointWrench push;
  push.axes = 0;
  push.point_frame = kWorld;
  EXPECT_THROW(sim.applyWrench("", push), std::invalid_argument);
  EXPECT_EQ(sim.wrenchCount(), 0u);
}

}  // namespace
}  // namespace rigid_body_sim
