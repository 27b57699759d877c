#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "support/contact_benches.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

constexpr double kTolerance = 1e-7;

bool isAtRest(const Simulation& sim, std::size_t body = 0) {
  for (const MotionPlan& plan : sim.plans())
    if (std::count(plan.bodies.begin(), plan.bodies.end(), body) > 0) return plan.at_rest;
  return false;
}

/// Damped so that rest comes within a second or two.
ContactParameters dampedContact(double dissipation) {
  ContactParameters parameters = contactOf(1e5, 1.5, dissipation, 0.5);
  parameters.breakaway = 1e-4;
  return parameters;
}

/// On a slope of 0.3 rad, whose friction holds it up to 0.46 rad.
Bench boxOnASlope() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  const HalfSpace plane = test::slope(0.3);
  BodyFrameMotion motion = motionAt(plane.q_WH * Vector3d(0, 0, 0.1));
  motion.q_WB = plane.q_WH;
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, motion, plane, dampedContact(3));
  return bench;
}

Bench tossedBox(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  BodyFrameMotion motion = motionAt({0, 0, 0.4}, vector(), 3 * vector());
  motion.q_WB = rotationExp(Vector3d(2 * vector()));
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, motion, test::slope(0), dampedContact(3));
  return bench;
}

/// The same bodies, never put to rest: nothing is known of a spring, even of one that pulls
/// nothing.
Bench awake(Bench bench) {
  bench.addSpring({0, Vector3d::Zero()}, {kWorld, {0, 0, 5}}, {0, 0, 0});
  return bench;
}

Simulation atTolerance(const Bench& bench) { return test::simulationAt(bench, kTolerance, 0.01); }

void stepUntilRest(Simulation& sim, double latest) {
  while (!isAtRest(sim) && sim.time() < latest) sim.step();
  ASSERT_TRUE(isAtRest(sim));
}

void stepTo(Simulation& sim, double t) {
  while (sim.time() < t - 1e-9) sim.step();
}

TEST(Rest, CostsNothingForAnHour) {
  Simulation sim = atTolerance(boxOnASlope());
  stepUntilRest(sim, 10);
  const std::int64_t evaluations = sim.evaluations();
  const BodyState before = sim.body(0);
  stepTo(sim, 3600);
  EXPECT_EQ(sim.evaluations(), evaluations);
  EXPECT_EQ(distanceBetween(sim.body(0), before), 0);
  EXPECT_TRUE(isAtRest(sim));
  EXPECT_NE(describeSolution(sim)[0].find("at rest"), std::string::npos)
      << describeSolution(sim)[0];
}

// A tenth of the tolerance, of radii of gyration where it is of places, is what rest promises.
TEST(Rest, IsWhereABodyLeftAwakeEndsUp) {
  std::mt19937 random(31);
  for (int i = 0; i < 2; ++i) {
    const Bench bench = tossedBox(random);
    Simulation sim = atTolerance(bench), moving = atTolerance(awake(bench));
    stepUntilRest(sim, 20);
    stepTo(moving, sim.time());
    const double size = radiusOfGyration(bench.world.bodies[0]);
    for (int steps = 0; steps < 50; ++steps) {
      EXPECT_LT(distanceBetween(sim.body(0), moving.body(0)), 0.1 * kTolerance * size) << i;
      EXPECT_LT(angleBetween(sim.body(0).q_WP, moving.body(0).q_WP), 0.1 * kTolerance) << i;
      sim.step();
      moving.step();
    }
    EXPECT_TRUE(isAtRest(sim));
    EXPECT_FALSE(isAtRest(moving));
  }
}

TEST(Rest, BeginsNoEarlierThanTheMotionAllows) {
  std::mt19937 random(32);
  Simulation sim = atTolerance(tossedBox(random));
  double energy = 0;
  for (; !isAtRest(sim) && sim.time() < 20; sim.step())
    energy = kineticEnergy(sim.world().bodies[0], sim.body(0));
  // ½ m (ω x)², with the slowest swing of four corners of stiffness p k √δ, δ = (m g/4 k)^(2/3)
  const double k = 1e5, weight = 5 * 9.80665, depth = std::pow(weight / (4 * k), 2. / 3);
  const double square = 4 * 1.5 * k * std::sqrt(depth) / 5;
  const double size = radiusOfGyration(sim.world().bodies[0]);
  EXPECT_LT(energy, 0.5 * 5 * square * std::pow(0.1 * kTolerance * size, 2));
  EXPECT_GT(energy, 0);
}

TEST(Rest, EndsAtTheInstantAtWhichAWrenchBegins) {
  Bench bench = boxOnASlope();
  bench.world.wrenches.push_back(test::worldForce({60, 10, 80}, 4.12345, 4.2));
  Simulation sim = atTolerance(bench), moving = atTolerance(awake(bench));
  stepTo(sim, 4.12);
  EXPECT_TRUE(isAtRest(sim));
  stepTo(sim, 4.3);
  EXPECT_FALSE(isAtRest(sim));
  stepTo(moving, 4.3);
  EXPECT_GT(sim.body(0).p_W.norm(), 1);
  EXPECT_LT(distanceBetween(sim.body(0), moving.body(0)), 1e-7);
  EXPECT_LT((sim.body(0).p_W - moving.body(0).p_W).norm(), 1e-5);
}

TEST(Rest, EndsWithAnyInput) {
  Simulation still = atTolerance(boxOnASlope());
  stepUntilRest(still, 10);
  Simulation pushed = still, placed = still;
  pushed.applyWrench("push", test::worldForce({0, 0, 1}, 0, 1e9));
  pushed.step();
  EXPECT_FALSE(isAtRest(pushed));
  EXPECT_NE(distanceBetween(pushed.body(0), still.body(0)), 0);
  BodyState lifted = placed.body(0);
  lifted.x_W.z() += 0.1;
  placed.setState(0, lifted);
  placed.step();
  EXPECT_FALSE(isAtRest(placed));
  EXPECT_LT(placed.body(0).p_W.z(), -0.4);
  still.reset(true);
  EXPECT_FALSE(isAtRest(still));
}

TEST(Rest, GoesOnFromAStateWithTheSameBits) {
  Bench bench = boxOnASlope();
  bench.world.wrenches.push_back(test::worldForce({0, 0, 80}, 4.5, 4.6));
  Simulation whole = atTolerance(bench);
  stepTo(whole, 4);
  Simulation cut(whole.world(), whole.state());
  EXPECT_TRUE(isAtRest(cut));
  stepTo(whole, 4.7);
  stepTo(cut, 4.7);
  EXPECT_EQ(cut.body(0).x_W, whole.body(0).x_W);
  EXPECT_EQ(cut.body(0).L_P, whole.body(0).L_P);
  EXPECT_EQ(cut.state().laws, whole.state().laws);
}

/// Two balls that touch each other in a gutter of two slopes.
Bench ballsInAGutter() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  ContactParameters parameters = dampedContact(3);
  parameters.rolling_friction = 1e-3;
  for (double x : {-0.1, 0.1}) {
    const std::size_t ball =
        test::addBall(bench, 0.1, 1, motionAt({x, 0, 0.142}), test::slope(0.7), parameters);
    bench.world.laws.push_back(contactWithHalfSpace(bench.world.bodies, ball, test::ballShape(0.1),
                                                    test::slope(-0.7), parameters));
  }
  bench.world.laws.push_back(contactOfBalls(bench.world.bodies, 0, test::ballShape(0.1), 1,
                                            test::ballShape(0.1), dampedContact(3)));
  return bench;
}

TEST(Rest, IsFoundOfBodiesThatTouch) {
  Simulation sim = atTolerance(ballsInAGutter());
  stepUntilRest(sim, 30);
  const std::vector<MotionPlan> plans = sim.plans();
  ASSERT_EQ(plans.size(), 1U);
  EXPECT_EQ(plans[0].bodies.size(), 2U);
  const std::int64_t evaluations = sim.evaluations();
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_EQ(sim.evaluations(), evaluations);
}

// A ball falls on one that rests; nothing of that one moves before.
TEST(Rest, EndsAtATouch) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  ContactParameters parameters = dampedContact(3);
  parameters.rolling_friction = 1e-3;
  test::addBall(bench, 0.1, 1, motionAt({0, 0, 0.1}), test::slope(0), parameters);
  test::addBall(bench, 0.1, 1, motionAt({0.02, 0, 0.4}, {0, 0, 50}), test::slope(0), parameters);
  bench.world.laws.push_back(contactOfBalls(bench.world.bodies, 0, test::ballShape(0.1), 1,
                                            test::ballShape(0.1), dampedContact(3)));
  Simulation sim = atTolerance(bench);
  stepTo(sim, 10);
  ASSERT_TRUE(isAtRest(sim));
  const BodyState before = sim.body(0);
  while (sim.contactEvents().empty() && sim.time() < 12) {
    EXPECT_EQ(distanceBetween(sim.body(0), before), 0);
    EXPECT_TRUE(isAtRest(sim));
    sim.step();
  }
  // free fall from 0.4 m at 50 m/s up, down to where the centres are 0.2 m apart
  const double fall = 0.4 - before.x_W.z() - std::sqrt(0.04 - 0.02 * 0.02);
  const double g = 9.80665, touch = (50 + std::sqrt(2500 + 2 * g * fall)) / g;
  ASSERT_FALSE(sim.contactEvents().empty());
  EXPECT_NEAR(sim.contactEvents()[0].t, touch, 1e-9);
  EXPECT_FALSE(isAtRest(sim));
  EXPECT_GT(sim.body(0).p_W.norm(), 1e-3);
}

TEST(Rest, NeverBeginsWhereMotionGoesOn) {
  Bench bouncing = boxOnASlope();
  bouncing.world.laws[0] = contactWithHalfSpace(
      bouncing.world.bodies, 0, test::cornersOf(bouncing.world.bodies[0], {0.4, 0.3, 0.2}),
      test::slope(0.3), dampedContact(0));
  Bench spinning;
  spinning.world.g_W = {0, 0, -9.80665};
  test::addBall(spinning, 0.1, 1, motionAt({0, 0, 0.1}, {0, 0, 0}, {0, 0, 1e-4}), test::slope(0),
                dampedContact(3));
  for (const Bench& bench : {bouncing, spinning}) {
    Simulation sim = atTolerance(bench);
    stepTo(sim, 3);
    EXPECT_FALSE(isAtRest(sim));
  }
}

// What little motion is left is counted as dissipated.
TEST(Rest, KeepsTheBalance) {
  Simulation sim = atTolerance(boxOnASlope());
  sim.trackBalance();
  stepUntilRest(sim, 10);
  stepTo(sim, sim.time() + 1);
  EXPECT_NEAR(sim.balance().energy, 0, 1e-11);
  EXPECT_NEAR(sim.balance().momentum.norm(), 0, 1e-9);
}

}  // namespace
}  // namespace rigid_body_sim
