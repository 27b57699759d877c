#include <gtest/gtest.h>

#include "support/random_bodies.hpp"
#include "support/reference_bench.hpp"
#include "support/worlds.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;
using test::restingBox;
using test::worldForce;

TEST(Simulation, GivesTheExactImpulseWhateverTheStep) {
  for (const char* integrator : {"semi_implicit_euler", "strang", "rk4"}) {
    Bench bench = restingBox();
    PointWrench push = worldForce({1, 2, 12}, 0.0123, 0.0123 + 2.00491);
    push.point = {0.3, -0.1, 0.05};
    bench.world.wrenches.push_back(push);
    const State end = bench.run(integrator, 3, 300);
    const Vector3d impulse = push.force * 2.00491;
    EXPECT_LE((end.bodies[0].p_W - impulse).norm(), 1e-13 * impulse.norm()) << integrator;
  }
}

// Nor that wrenches of others are cleared, those that turn with a third body included.
TEST(Simulation, LeavesBodiesAloneThatAClearingDoesNotTouch) {
  Bench bench = test::complexBox();
  for (const char* name : {"other", "third"})
    bench.add(test::principalBody(name, 1, {1, 2, 3}), test::tumbling({0, 0, 0}, {1, 2, 3}));
  Simulation left_alone = bench.simulation("auto", 0.01), cleared = left_alone;
  for (int i = 0; i < 100; ++i) {
    PointWrench held = worldForce({0, 1, 0}, 0, 10), coupled = held;
    held.body = held.point_frame = coupled.body = coupled.point_frame = 1;
    coupled.axes = 2;
    cleared.applyWrench("held", held);
    cleared.step();
    cleared.clearWrenches(ClearInput::kEveryBody, i % 2 == 0 ? "held" : "none");
    cleared.clearWrenches(2);
    cleared.applyWrench("coupled", coupled);
    cleared.step();
    cleared.clearWrenches(1, "coupled");
    left_alone.step();
    left_alone.step();
    const BodyState &a = left_alone.body(0), &b = cleared.body(0);
    ASSERT_EQ(a.q_WP.coeffs(), b.q_WP.coeffs()) << i;
    ASSERT_EQ(a.x_W, b.x_W) << i;
  }
  EXPECT_EQ(cleared.plans().size(), 3u);
}

TEST(Simulation, HoldsAWrenchInTheAxesOfAnotherBody) {
  Bench bench = restingBox();
  bench.add(test::principalBody("turning", 1, {1, 1, 1}), test::tumbling({0, 0, 0}, {0, 0, 2}));
  Simulation sim = bench.simulation("rk4", 0.001);
  PointWrench push;
  push.axes = 1;
  push.force = {3, 0, 0};
  sim.applyWrench("arm", push);
  for (int i = 0; i < 1000; ++i) sim.step();
  // p = ∫ 3 (cos 2t, sin 2t) dt
  const Vector3d p(1.5 * std::sin(2.0), 1.5 * (1 - std::cos(2.0)), 0);
  EXPECT_LE((sim.body(0).p_W - p).norm(), 1e-12);
  EXPECT_LE((sim.appliedWrench(0).f_W - Vector3d(3 * std::cos(2.0), 3 * std::sin(2.0), 0)).norm(),
            1e-11);
  sim.clearWrenches(0, "arm");
  EXPECT_EQ(sim.wrenchCount(), 0u);
}

// 0.1 + 0.2 is more than 300 times 0.001, in doubles.
TEST(Simulation, EndsAWrenchWithTheStepThatItsEndMissesByRounding) {
  Simulation sim = restingBox().simulation("auto", 0.001);
  sim.applyWrench("", worldForce({1, 0, 0}, 0.1, 0.1 + 0.2));
  while (sim.steps() < 299) sim.step();
  EXPECT_EQ(sim.activeWrenches(0).size(), 1u);
  sim.step();
  EXPECT_TRUE(sim.activeWrenches(0).empty());
  EXPECT_EQ(sim.body(0).p_W.x(), 0.3 - 0.1);
}

// A new random wrench every 10 ms, no multiple of the step: solved to rounding. 1e-12 rad is what
// the reference and the growth of rounding by the motion leave.
TEST(Simulation, FollowsAThousandWrenchChangesToRounding) {
  for (const std::size_t axes : {kWorld, std::size_t{0}}) {
    Bench bench;
    bench.add(test::principalBody("box", 2, {0.052, 0.177, 0.208}),
              test::tumbling({0.5, 0, 1}, {1, -0.7, 0.4}));
    Draw draw(7);
    for (int k = 0; k < 1000; ++k) {
      PointWrench push;
      push.axes = axes;
      push.force = draw.vector(1);
      push.torque = draw.vector(0.2);
      push.point = draw.vector(0.3);
      push.start = 0.01 * k;
      push.end = 0.01 * (k + 1);
      bench.world.wrenches.push_back(push);
    }
    const auto errors =
        test::motionErrors(bench.run("auto", 10, 1429), test::referenceRun(bench, 10));
    EXPECT_LT(errors.attitude, 1e-12);
    EXPECT_LT(errors.position, 1e-12 * 15);  // [m] of some 15 m flown
  }
}

TEST(Simulation, RefusesOneWrenchMoreThanMayBeToCome) {
  Bench bench = restingBox();
  bench.world.wrenches.assign(Simulation::kMaxWrenches, worldForce({1, 0, 0}, 10, 11));
  Simulation sim = bench.simulation("auto", 0.1);
  const auto apply = [&sim] { sim.applyWrench("", worldForce({1, 0, 0}, 0, 1)); };
  try {
    apply();
    FAIL() << "taken";
  } catch (const std::invalid_argument& refused) {
    EXPECT_STREQ(refused.what(), "at most 100000 wrenches may act or be to come");
  }
  EXPECT_EQ(sim.wrenchCount(), Simulation::kMaxWrenches);
  sim.clearWrenches();
  EXPECT_NO_THROW(apply());
}

TEST(Simulation, TakesAWrenchInTheOthersPlaceWhenNoMoreMayBe) {
  Bench bench = restingBox();
  bench.world.wrenches.assign(Simulation::kMaxWrenches - 1, worldForce({1, 0, 0}, 10, 11));
  Simulation sim = bench.simulation("auto", 0.1);
  for (int i = 0; i < 3; ++i) sim.applyWrench("held", worldForce({1, 0, 0}, 0, 1));
  EXPECT_EQ(sim.wrenchCount(), Simulation::kMaxWrenches);
  EXPECT_THROW(sim.applyWrench("held", worldForce({1, 0, 0}, 0.5, 1)), std::invalid_argument);
  EXPECT_THROW(sim.applyWrench("other", worldForce({1, 0, 0}, 0, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace rigid_body_sim
