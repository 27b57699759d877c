#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "dynamics/run/contact_bound.hpp"
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

/// The same on a harder ground, to a stated tolerance.
Bench hardLanding(double stiffness = 1e8) {
  Bench bench = fallingBox();
  bench.world.laws[0] = contactWithHalfSpace(
      bench.world.bodies, 0, test::cornersOf(bench.world.bodies[0], {0.4, 0.3, 0.2}),
      test::slope(0), contactOf(stiffness, 1.5, 0.2, 0.5));
  bench.world.solver.tolerance = 1e-6;
  bench.world.solver.tolerance_stated = true;
  bench.world.solver.horizon = 1.5;
  return bench;
}

/// Its start, with the bound that contact has before a trial.
State untried(const Bench& bench) {
  State state = bench.initial;
  state.contact_bound = contactStepBound(bench.world.solver.tolerance);
  return state;
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

// Its first bound would not do: the impacts of a box on a hard ground magnify errors too much.
TEST(Promise, IsKeptToTheHorizonByTighterSteps) {
  Bench bench = hardLanding();
  bench.world.solver.tolerance = 1e-7;
  const double tolerance = bench.world.solver.tolerance, horizon = bench.world.solver.horizon;
  Simulation sim = bench.simulation("auto", 0.005);
  EXPECT_LT(sim.contactTrial().step_bound, 0.1 * contactStepBound(tolerance));
  EXPECT_TRUE(std::isinf(sim.contactTrial().lost_at));
  EXPECT_NEAR(sim.contactTrial().tried_until, horizon, 1e-9);
  Simulation loose = sim;
  loose.load(untried(bench));
  EXPECT_EQ(loose.state().contact_bound, contactStepBound(tolerance));
  Simulation truth = test::simulationAt(bench, 1e-10, 0.005);
  for (Simulation* each : {&sim, &loose}) each->trackError();
  while (sim.time() < horizon - 1e-9) {
    for (Simulation* each : {&sim, &loose, &truth}) each->step();
    EXPECT_LT(angleBetween(sim.body(0).q_WP, truth.body(0).q_WP), tolerance) << sim.time();
  }
  EXPECT_EQ(describePromise(sim), "");
  EXPECT_NE(describePromise(loose), "");
}

TEST(Promise, IsSaidBeforeTheRunToBeLostWhereNoStepHoldsIt) {
  Bench bench = hardLanding();
  bench.world.solver.horizon = 3;
  const Simulation sim = bench.simulation("auto", 0.005);
  EXPECT_EQ(sim.contactTrial().step_bound, kLeastContactBound);
  EXPECT_LT(sim.contactTrial().lost_at, 3);
  const std::vector<std::string> lines = describeSolution(sim);
  EXPECT_NE(lines.back().find("tolerance 1e-06 is not certain to be held from"), std::string::npos)
      << lines.back();
}

// What a trial may cost does not grow with the scene.
TEST(Promise, IsTriedForNoLongerThanItsWorkAllows) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  bench.world.solver.horizon = 1000;
  for (int i = 0; i < 40; ++i)
    test::addBall(bench, 0.1, 1, motionAt({i * 1.0, 0, 0.4}), test::slope(0),
                  contactOf(1e6, 1.5, 0, 0.5));
  bench.world.solver.tolerance = 1e-6;
  bench.world.solver.tolerance_stated = true;
  const Simulation sim = bench.simulation("auto", 0.01);
  EXPECT_GT(sim.contactTrial().tried_until, 0.1);
  EXPECT_LT(sim.contactTrial().tried_until, 500);
  EXPECT_NE(describeSolution(sim).back().find("to hold up to"), std::string::npos);
}

// Contact is integrated in steps of its own, however long those of the world are.
TEST(Promise, IsTriedWithinOneLongStep) {
  Bench bench = hardLanding();
  bench.world.solver.tolerance = 1e-7;  // at the first bound, errors come to five times that
  const double horizon = bench.world.solver.horizon;
  for (const double time_step : {0.005, 0.51 * horizon, horizon, 10 * horizon}) {
    const ContactTrial trial = bench.simulation("auto", time_step).contactTrial();
    EXPECT_TRUE(trial.compares);
    EXPECT_NEAR(trial.step_bound / contactStepBound(1e-7), 0.01, 1e-6) << time_step;
    EXPECT_TRUE(std::isinf(trial.lost_at));
    EXPECT_NEAR(trial.tried_until, horizon, horizon / 32);
  }
}

// A single step of a day: the work of the trial ends within it.
TEST(Promise, IsSaidToBeUnknownWhereATrialTellsNothing) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  bench.world.solver.horizon = 86400 * 100;
  for (int i = 0; i < 5; ++i)
    test::addBall(bench, 0.1, 1, motionAt({i * 1.0, 0, 0.4}), test::slope(0),
                  contactOf(1e6, 1, 0, 0));
  bench.world.solver.tolerance = 1e-6;
  bench.world.solver.tolerance_stated = true;
  const Simulation sim = bench.simulation("auto", bench.world.solver.horizon);
  EXPECT_TRUE(sim.contactTrial().is_made);
  EXPECT_FALSE(sim.contactTrial().compares);
  EXPECT_NE(
      describeSolution(sim).back().find("contact: whether tolerance 1e-06 holds is not known"),
      std::string::npos)
      << describeSolution(sim).back();
}

// Tighter steps there are none, but the user is told.
TEST(Promise, IsTriedAtTheLeastBoundToo) {
  Bench bench = hardLanding();
  bench.world.solver.tolerance = 1e-13;
  const Simulation sim = bench.simulation("auto", 0.005);
  EXPECT_EQ(sim.contactTrial().step_bound, contactStepBound(kTightestInContact));
  EXPECT_LT(sim.contactTrial().lost_at, bench.world.solver.horizon);
  EXPECT_NE(describeSolution(sim).back().find("steps cannot be tighter"), std::string::npos);
}

// It would hold the first seconds of a day to a tolerance that nobody knows to hold then.
TEST(Promise, PaysForNothingOfWhichATrialTellsLittle) {
  Bench bench = hardLanding(5e7);
  bench.world.solver.horizon = 3;
  EXPECT_LT(bench.simulation("auto", 0.005).contactTrial().step_bound, contactStepBound(1e-6));
  bench.world.solver.horizon = 86400;
  const ContactTrial trial = bench.simulation("auto", 0.005).contactTrial();
  EXPECT_EQ(trial.step_bound, contactStepBound(1e-6));
  // the first bound has been tried until the tolerance was exceeded, the next not far enough
  EXPECT_GT(trial.lost_at, 1);
  EXPECT_LT(trial.lost_at, 8640);
}

TEST(Promise, GoesOnFromAStateWithTheBoundThatItHad) {
  const Bench bench = hardLanding();
  Simulation whole = bench.simulation("auto", 0.005);
  for (int i = 0; i < 60; ++i) whole.step();
  World world = whole.world();
  Simulation rest(world, whole.state()), loaded = bench.simulation("auto", 0.005);
  loaded.load(whole.state());
  EXPECT_EQ(rest.contactTrial().step_bound, whole.contactTrial().step_bound);
  for (int i = 0; i < 60; ++i)
    for (Simulation* each : {&whole, &rest, &loaded}) each->step();
  for (const Simulation* each : {&rest, &loaded}) {
    EXPECT_EQ(each->body(0).x_W, whole.body(0).x_W);
    EXPECT_EQ(each->body(0).q_WP.coeffs(), whole.body(0).q_WP.coeffs());
  }
}

TEST(Promise, IsMadeAnewByAReset) {
  Simulation sim = test::simulationAt(fallingBox(), 1e-14, 0.005);
  sim.trackError();
  firstTouch(sim);
  sim.reset(true);
  EXPECT_TRUE(std::isinf(sim.errorEstimate().lost_at));
}

// What the trial has found is of the motion from its start, which comes later now.
TEST(Promise, CountsFromAResetThatLetsTimeRunOn) {
  Bench bench = hardLanding();
  bench.world.solver.horizon = 3;
  Simulation sim = bench.simulation("auto", 0.005);
  const double lost_at = sim.contactTrial().lost_at;
  while (sim.time() < 3.5) sim.step();
  const double reset_at = sim.time();
  sim.reset(false);
  EXPECT_EQ(sim.horizonBegins(), reset_at);
  EXPECT_EQ(sim.contactTrial().lost_at, reset_at + lost_at);
  sim.trackError();
  while (sim.time() < reset_at + 3) sim.step();
  EXPECT_GT(sim.errorEstimate().lost_at, reset_at);
  EXPECT_LT(sim.errorEstimate().lost_at, reset_at + 3);
  sim.reset(true);
  EXPECT_EQ(sim.horizonBegins(), 0);
  EXPECT_EQ(sim.contactTrial().lost_at, lost_at);
}

}  // namespace
}  // namespace rigid_body_sim
