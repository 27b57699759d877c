#include <cmath>
#include <cstdint>
#include <memory>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/spring.hpp>

#include "support/counted_law.hpp"
#include "support/worlds.hpp"

/// What a reset costs: auto has tried the start before.
namespace rigid_body_sim {
namespace {

/// A box that swings on a spring, which counts, in a world with a body that flies; and whether a
/// wrench on the box is to come.
class ResetTest : public ::testing::Test {
 protected:
  Simulation simulation(bool scheduled = false) {
    test::Bench bench;
    bench.world.g_W = {0, 0, -10};
    bench.world.solver.horizon = 1;
    bench.add(test::principalBody("box", 2, {0.5, 0.7, 0.9}), test::tumbling({1, 0, 0}, {0, 1, 2}));
    bench.add(test::principalBody("stone", 1, {1, 1, 1}), test::tumbling({1, 0, 0}, {0, 1, 2}));
    bench.world.laws.push_back(std::make_shared<test::CountedLaw>(
        std::make_shared<Spring>(Spring::End{kWorld, {0, 0, 1.6}}, Spring::End{0, {0, 0, 0.1}},
                                 Spring::Constants{40, 0, 1}),
        asked));
    PointWrench push;
    push.force = {1, 0, 0};
    push.start = 0.5;
    push.end = 0.6;
    if (scheduled) bench.world.wrenches = {push};
    return bench.simulation("auto", 0.01);
  }

  std::int64_t askedByReset(Simulation& sim, bool restart_time) {
    const std::int64_t before = asked;
    sim.reset(restart_time);
    return asked - before;
  }

  static void expectSamePlan(const Simulation& sim, const MotionPlan& start) {
    const MotionPlan plan = sim.plans()[0];
    EXPECT_EQ(plan.integrator, start.integrator);
    EXPECT_EQ(plan.substeps, start.substeps);
    EXPECT_EQ(plan.error, start.error);
    EXPECT_NEAR(plan.tried_until - sim.time(), start.tried_until, 1e-12);
  }

  std::int64_t asked = 0;
};

constexpr std::int64_t kNoTrial = 10;  // one asks more than a thousand times

}  // namespace

TEST_F(ResetTest, TakesWhatTheTrialsOfTheStartHaveFound) {
  Simulation sim = simulation();
  ASSERT_GT(asked, 100 * kNoTrial);
  const MotionPlan start = sim.plans()[0];
  ASSERT_TRUE(std::isfinite(start.tried_until));
  for (const bool restart_time : {false, false, true, false}) {
    sim.step(150);  // beyond what was tried
    EXPECT_LE(askedByReset(sim, restart_time), kNoTrial);
    expectSamePlan(sim, start);
  }
}

TEST_F(ResetTest, TakesItBackAfterAnotherMassAndAnAbsence) {
  Simulation sim = simulation();
  const MotionPlan start = sim.plans()[0];
  for (const bool restart_time : {false, true}) {
    sim.setMassProperties(0, {4, Vector3d::Zero(), Vector3d(2, 3, 4).asDiagonal()});
    sim.setPresent(1, std::nullopt);
    sim.step(3);
    EXPECT_LE(askedByReset(sim, restart_time), kNoTrial);
    expectSamePlan(sim, start);
  }
}

// The wrenches of the scene do not come again unless time does.
TEST_F(ResetTest, TriesOnceWhatHasAWrenchOfTheSceneNoMore) {
  Simulation sim = simulation(true);
  sim.step(3);
  EXPECT_GT(askedByReset(sim, false), kNoTrial);
  EXPECT_LE(askedByReset(sim, false), kNoTrial);
  EXPECT_LE(askedByReset(sim, true), kNoTrial);
}

}  // namespace rigid_body_sim
