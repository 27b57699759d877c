#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "support/worlds.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;
using test::restingBox;
using test::worldForce;

TEST(Simulation, CountsTimeInWholeSteps) {
  Simulation sim = restingBox().simulation("strang", 0.1);
  for (int i = 0; i < 1000; ++i) sim.step();
  EXPECT_EQ(sim.steps(), 1000);
  EXPECT_EQ(sim.time(), 1000 * 0.1);
}

TEST(Simulation, RepeatsTheSameBits) {
  const Bench bench = test::pushedBox(kWorld, 0);
  const State a = bench.run("strang", 1, 100);
  const State b = bench.run("strang", 1, 100);
  EXPECT_EQ(a.bodies[0].q_WP.coeffs(), b.bodies[0].q_WP.coeffs());
  EXPECT_EQ(a.bodies[0].x_W, b.bodies[0].x_W);
}

TEST(Simulation, SamplesBetweenStepsWithoutDisturbingTheRun) {
  const Bench bench = test::pushedBox(kWorld, 0);
  Simulation asked = bench.simulation("rk4", 0.01);
  Simulation left_alone = bench.simulation("rk4", 0.01);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(asked.sample(asked.time() + 0.0042).t, asked.time() + 0.0042);
    const State whole = asked.sample(0.01 * (i + 1));
    asked.step();
    left_alone.step();
    EXPECT_EQ(asked.body(0).q_WP.coeffs(), left_alone.body(0).q_WP.coeffs());
    EXPECT_EQ(asked.body(0).q_WP.coeffs(), whole.bodies[0].q_WP.coeffs());
  }
}

// What a run would go on from is not put together where nobody asks for it.
TEST(Simulation, SamplesThePresentWithItsBitsAndNoMore) {
  for (const char* integrator : {"auto", "strang", "rk4"}) {
    Simulation sim = test::pushedBox(kWorld, 0).simulation(integrator, 0.01);
    for (int i = 0; i < 5; ++i) sim.step();
    const State now = sim.state(), sampled = sim.sample(sim.time());
    EXPECT_EQ(sampled.t, now.t);
    EXPECT_EQ(sampled.bodies[0].x_W, now.bodies[0].x_W) << integrator;
    EXPECT_EQ(sampled.bodies[0].L_P, now.bodies[0].L_P) << integrator;
    EXPECT_EQ(sampled.bodies[0].q_WP.coeffs(), now.bodies[0].q_WP.coeffs()) << integrator;
    EXPECT_FALSE(now.plans.empty() || now.anchors.empty() || now.schedules.empty());
    EXPECT_TRUE(sampled.plans.empty() && sampled.anchors.empty() && sampled.schedules.empty());
  }
}

TEST(SimulationDiverged, TellsItsTimeInTheFewestDigits) {
  EXPECT_STREQ(SimulationDiverged(1.11, "box", "it spins too fast").what(),
               "t = 1.11 s: body 'box': it spins too fast");
}

TEST(Simulation, StopsAtTheLastFiniteStateAndNamesTheBody) {
  Bench bench = restingBox();
  Simulation sim = bench.simulation("strang", 1.0);
  sim.step();
  sim.applyWrench("", worldForce({1e300, 0, 0}, 0, 1e300));
  PointWrench twist;
  twist.torque = {0, 1e308, 1e308};
  sim.applyWrench("", twist);
  try {
    for (int i = 0; i < 100; ++i) sim.step();
    FAIL() << "went on";
  } catch (const SimulationDiverged& diverged) {
    EXPECT_EQ(diverged.body, "box");
    EXPECT_GE(diverged.time, 1.0);
    EXPECT_NE(std::string(diverged.what()).find("body 'box'"), std::string::npos);
  }
  EXPECT_TRUE(sim.body(0).q_WP.coeffs().allFinite());
  EXPECT_TRUE(sim.body(0).L_W.allFinite());
}

TEST(Simulation, ResetRestoresTheStartAndClearsWrenches) {
  const Bench bench = test::pushedBox(kWorld, 0);
  Simulation sim = bench.simulation("strang", 0.01);
  for (int i = 0; i < 10; ++i) sim.step();
  const State first = sim.state();
  sim.reset(false);
  EXPECT_EQ(sim.time(), first.t);
  EXPECT_EQ(sim.wrenchCount(), 0u);
  EXPECT_EQ(sim.body(0).q_WP.coeffs(), bench.initial.bodies[0].q_WP.coeffs());
  sim.reset(true);
  EXPECT_EQ(sim.time(), 0);
  EXPECT_EQ(sim.wrenchCount(), 1u);
  for (int i = 0; i < 10; ++i) sim.step();
  EXPECT_EQ(sim.body(0).q_WP.coeffs(), first.bodies[0].q_WP.coeffs());
}

TEST(Simulation, LeavesFixedBodiesWhereTheyAre) {
  Bench bench = test::complexBox();
  bench.world.g_W = {0, 0, -9.8};
  bench.fix(0);
  const State end = bench.run("strang", 1, 100);
  EXPECT_EQ(end.bodies[0].x_W, bench.initial.bodies[0].x_W);
  EXPECT_EQ(end.bodies[0].q_WP.coeffs(), bench.initial.bodies[0].q_WP.coeffs());
}

// A body does not feel that others are simulated beside it, to the last bit.
TEST(Simulation, AdvancesIndependentBodiesApart) {
  const Bench alone = test::pushedBox(kWorld, 0);
  Bench both = alone;
  both.add(test::principalBody("other", 1, {1, 2, 3}), test::tumbling({0, 0, 0}, {1, 2, 3}));
  PointWrench on_other = worldForce({0, 1, 0}, 0.123, 0.345);
  on_other.body = on_other.point_frame = 1;
  both.world.wrenches.push_back(on_other);
  EXPECT_EQ(alone.run("strang", 1, 100).bodies[0].q_WP.coeffs(),
            both.run("strang", 1, 100).bodies[0].q_WP.coeffs());
}

// The first body's wrench begins within the step in which the second diverges.
TEST(Simulation, GoesOnAfterAStepThatFailedAsIfItHadNeverBegun) {
  for (const char* integrator : {"auto", "strang"}) {
    Bench bench = restingBox();
    bench.add(test::principalBody("other", 1, {1, 2, 3}), BodyFrameMotion());
    bench.world.wrenches.push_back(worldForce({1, 0, 0}, 0.75, 2.5));
    Simulation sim = bench.simulation(integrator, 1);
    PointWrench twist;
    twist.body = twist.point_frame = 1;
    twist.torque = {0, 1e308, 1e308};
    sim.applyWrench("twist", twist);
    EXPECT_THROW(sim.step(), SimulationDiverged) << integrator;
    EXPECT_EQ(sim.time(), 0);
    sim.clearWrenches(1);
    sim.step();
    EXPECT_EQ(sim.body(0).p_W.x(), 0.25) << integrator;
    EXPECT_EQ(sim.body(0).x_W.x(), 0.25 * 0.25 / 4) << integrator;
  }
}

TEST(Simulation, DivergesBetweenStepsAsAtTheirEnd) {
  for (const char* integrator : {"auto", "strang"}) {
    Bench bench = restingBox();
    PointWrench twist;
    twist.torque = {0, 1e308, 1e308};
    bench.world.wrenches.push_back(twist);
    const Simulation sim = bench.simulation(integrator, 1);
    try {
      sim.sample(0.5);
      FAIL() << integrator;
    } catch (const SimulationDiverged& diverged) {
      EXPECT_EQ(diverged.time, 0);
      EXPECT_EQ(diverged.body, "box");
    }
  }
}

TEST(Simulation, TracksTheErrorOfACopyApart) {
  const Bench bench = test::pushedBox(0, 0);
  Simulation sim = bench.simulation("strang", 0.01);
  sim.trackError();
  for (int i = 0; i < 10; ++i) sim.step();
  Simulation left_alone = sim, copy = sim;
  for (int i = 0; i < 10; ++i) {
    copy.applyWrench("", worldForce({1e3, 0, 0}, 0, 10));
    copy.step();
    left_alone.step();
  }
  for (int i = 0; i < 10; ++i) sim.step();
  EXPECT_EQ(sim.errorEstimate().attitude, left_alone.errorEstimate().attitude);
  EXPECT_EQ(sim.errorEstimate().position, left_alone.errorEstimate().position);
  EXPECT_NE(copy.errorEstimate().position, sim.errorEstimate().position);
}

// A millimetre a second, 1e9 m out, where the position is known to 1e-7 m only.
TEST(Simulation, MovesBodiesFarFromTheOrigin) {
  for (const Method& method : catalogue()) {
    Bench bench;
    BodyFrameMotion motion;
    motion.x_W = {1e9, 0, 0};
    motion.v_W = {1e-3, 0, 0};
    bench.add(test::principalBody("far", 1, {1, 2, 3}), motion);
    const BodyState end = bench.run(method.name, 1, 10000).bodies[0];
    EXPECT_NEAR((end.x_W.x() - 1e9) + end.x_low_W.x(), 1e-3, 1e-12) << method.name;
  }
}

TEST(Simulation, RefusesAnUnknownIntegratorAndListsTheKnown) {
  try {
    restingBox().simulation("euler", 0.01);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& refused) {
    const std::string message = refused.what();
    EXPECT_NE(message.find("strang"), std::string::npos) << message;
    EXPECT_NE(message.find("got 'euler'"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace rigid_body_sim
