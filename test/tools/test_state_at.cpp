#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/step_sampler.hpp>

#include "support/contact_benches.hpp"
#include "support/many_bodies.hpp"
#include "support/same_bits.hpp"
#include "tools/common/state_at.hpp"

// Steps that are taken together where nothing is to be done between them.

namespace rigid_body_sim {
namespace {

constexpr double kStep = 0.01;  // [s]

Simulation thrown(const std::string& integrator) {
  return test::thrownBodies(5).simulation(integrator, kStep);
}

TEST(StateAt, AsksForHooksOnlyWhereTheyAreNeeded) {
  Simulation simulation = thrown("strang");
  std::vector<std::int64_t> before, after;
  std::vector<double> reached;
  StepHooks hooks;
  hooks.before = [&] { before.push_back(simulation.steps()); };
  hooks.within = [&](double t) { reached.push_back(t); };
  hooks.after = [&] { after.push_back(simulation.steps()); };
  // something is to be done after steps 4 and 9
  hooks.free_steps = [&] { return (simulation.steps() < 4 ? 4 : 9) - simulation.steps(); };
  EXPECT_TRUE(stepTo(simulation, 0.11, hooks));
  EXPECT_EQ(before, (std::vector<std::int64_t>{0, 4, 9, 10}));
  EXPECT_EQ(after, (std::vector<std::int64_t>{4, 9, 10, 11}));
  EXPECT_EQ(reached, (std::vector<double>{1 * kStep, 5 * kStep, 10 * kStep, 11 * kStep}));
}

TEST(StateAt, CallsHooksAtEveryStepUnlessToldOtherwise) {
  Simulation simulation = thrown("strang");
  int calls = 0;
  StepHooks hooks;
  hooks.after = [&] { ++calls; };
  stepTo(simulation, 0.07, hooks);
  EXPECT_EQ(calls, 7);
}

TEST(StateAt, GivesTheBitsOfSingleSteps) {
  for (const char* integrator : {"auto", "semi_implicit_euler", "rk4"}) {
    Simulation at_once = thrown(integrator), singly = thrown(integrator);
    for (int i = 0; i < 12; ++i) singly.step();
    for (double t : {0.12, 0.125}) {
      const State state = stateAt(at_once, t), bodies = bodiesAt(at_once, t);
      const State expected = t > singly.time() ? singly.sample(t) : singly.state();
      EXPECT_EQ(bodies.t, state.t);
      ASSERT_EQ(bodies.bodies.size(), expected.bodies.size());
      for (std::size_t i = 0; i < expected.bodies.size(); ++i) {
        EXPECT_TRUE(test::sameBits(state.bodies[i], expected.bodies[i])) << integrator;
        EXPECT_TRUE(test::sameBits(bodies.bodies[i], expected.bodies[i])) << integrator;
      }
    }
  }
}

TEST(StateAt, CountsAnInstantThatMissesAStepByRoundingAsThatStep) {
  const Simulation simulation = thrown("strang");
  EXPECT_EQ(stepsBy(simulation, 0.03), 3);
  EXPECT_EQ(stepsBy(simulation, 0.03 * (1 - 1e-12)), 3);
  EXPECT_EQ(stepsBy(simulation, 0.0299), 2);
  EXPECT_GT(stepsBy(simulation, std::numeric_limits<double>::infinity()), std::int64_t{1} << 60);
}

TEST(StatesWithin, AreThoseOfSamples) {
  Simulation simulation = thrown("rk4");
  StatesWithin states;
  for (const double t : {0.002, 0.005, 0.007, 0.003})
    EXPECT_TRUE(test::sameBits(states.at(simulation, t).bodies[0], simulation.sample(t).bodies[0]));
}

TEST(StatesWithin, GoOnFromOneAnotherInContact) {
  test::Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  test::addBall(bench, 0.1, 1, test::motionAt({0, 0, 0.1}, {1, 0, 0}), HalfSpace{},
                test::contactOf(1e4, 1, 0.3, 0.5));
  Simulation simulation = bench.simulation("auto", 0.1);
  StatesWithin states;
  for (int k = 1; k < 30; ++k) {
    const double t = 0.01 * k;
    if (k % 10 == 0) simulation.step();
    const BodyState a = states.at(simulation, t).bodies[0], b = simulation.sample(t).bodies[0];
    EXPECT_NEAR((a.x_W - b.x_W).norm(), 0, 1e-11) << t;
    EXPECT_NEAR((a.p_W - b.p_W).norm(), 0, 1e-10) << t;
  }
}

}  // namespace
}  // namespace rigid_body_sim
