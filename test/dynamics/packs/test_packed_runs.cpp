#include <gtest/gtest.h>

#include "dynamics/run/run.hpp"
#include "support/changed_mass.hpp"
#include "support/many_bodies.hpp"
#include "support/same_bits.hpp"
#include "support/same_state.hpp"

// Runs in which packs step the bodies, beside the same runs while the balance is tracked: then each
// body is stepped by itself.

namespace rigid_body_sim {
namespace {

using test::expectSameBits;
using test::packedIntegrators;
using test::thrownBodies;

Simulation oneByOne(const test::Bench& bench, const std::string& integrator, double h) {
  Simulation simulation = bench.simulation(integrator, h);
  simulation.trackBalance();
  return simulation;
}

/// A push of a body without torque.
PointWrench pushOf(std::size_t body, double start, double end) {
  PointWrench push = test::worldForce({1, -2, 3}, start, end);
  push.body = push.point_frame = body;
  return push;
}

/// The same with a torque.
PointWrench turnOf(std::size_t body, double start, double end) {
  PointWrench turn = pushOf(body, start, end);
  turn.torque = {0.1, 0.2, -0.1};
  return turn;
}

rigid_body_sim::Run runOf(const test::Bench& bench, const std::string& integrator) {
  World world = bench.world;
  world.solver.integrator = integrator;
  world.solver.time_step = 0.01;
  return rigid_body_sim::Run(std::make_shared<const World>(world),
                             std::make_shared<const State>(bench.initial));
}

TEST(PackedRuns, HaveTheBitsOfBodiesByThemselves) {
  for (const std::string& integrator : packedIntegrators())
    for (std::size_t count : {1u, 2u, 3u, 7u, 9u, 70u}) {
      SCOPED_TRACE(integrator + ", bodies: " + std::to_string(count));
      const test::Bench bench = thrownBodies(count);
      Simulation packed = bench.simulation(integrator, 0.01),
                 singly = oneByOne(bench, integrator, 0.01);
      for (int i = 0; i < 150; ++i) {
        packed.step();
        singly.step();
        if (i % 10 == 0) expectSameBits(packed, singly);
      }
      expectSameBits(packed, singly);
      test::expectSameState(packed.state(), singly.state());
    }
}

TEST(PackedRuns, StepBodiesInPacks) {
  for (const std::string& integrator : packedIntegrators()) {
    rigid_body_sim::Run run = runOf(thrownBodies(20), integrator);
    run.step();
    EXPECT_EQ(run.now().packs.size(), 20u) << integrator;
    PointWrench pulled = turnOf(3, 0, 1);
    pulled.point_frame = kWorld;
    run.put("", pulled);
    EXPECT_EQ(run.now().packs.size(), 19u);
    run.step();
    EXPECT_FALSE(run.now().packs.holds(3));
    for (const PointWrench& push : {pushOf(4, 0, 1), turnOf(5, 0, 1)}) {
      run.put("a", push);
      EXPECT_FALSE(run.now().packs.holds(push.body));
      run.step();
      EXPECT_TRUE(run.now().packs.holds(push.body));
    }
  }
  rigid_body_sim::Run solved = runOf(thrownBodies(20), "auto");
  solved.step();
  EXPECT_EQ(solved.now().packs.size(), 0u);
}

TEST(PackedRuns, TakeSeveralStepsAtOnceWithTheSameBits) {
  for (const std::string& integrator : packedIntegrators()) {
    test::Bench bench = thrownBodies(30);
    bench.world.wrenches.push_back(pushOf(7, 0.333, 0.777));
    bench.world.wrenches.push_back(turnOf(8, 0.5, 0.901));
    Simulation at_once = bench.simulation(integrator, 0.01),
               singly = oneByOne(bench, integrator, 0.01);
    for (int count : {1, 2, 7, 64, 65, 100}) {
      at_once.step(count);
      singly.step(count);
      expectSameBits(at_once, singly);
    }
  }
}

// with bodies that are in no pack: one that is fixed, one that is absent, one that is pulled
TEST(PackedRuns, AreReadWhileTheyAreSteppedWithTheSameBits) {
  for (const std::string& integrator : packedIntegrators()) {
    test::Bench bench = thrownBodies(150);
    bench.fix(3);
    bench.world.bodies[70].absent = true;
    PointWrench pulled = turnOf(8, 0.5, 0.9);
    pulled.point_frame = kWorld;
    bench.world.wrenches = {pushOf(7, 0.333, 0.777), pulled};
    Simulation read = bench.simulation(integrator, 0.01), stepped = read;
    std::vector<BodyState> states;
    for (int count : {1, 1, 2, 40, 1, 65, 0, 1, 100}) {
      read.step(count, states);
      stepped.step(count);
      expectSameBits(read, stepped);
      const std::vector<BodyState> expected = stepped.bodies();
      ASSERT_EQ(states.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i)
        ASSERT_TRUE(test::sameBits(states[i], expected[i])) << integrator << ", body " << i;
    }
  }
}

// so many bodies that two threads are worthwhile
TEST(PackedRuns, AreReadByThreadsWithTheSameBits) {
  const test::Bench bench = thrownBodies(32771);
  test::expectBodiesReadByTwoThreads(bench.world, bench.initial, "semi_implicit_euler");
}

TEST(PackedRuns, TakeInputsInTheMiddle) {
  for (const std::string& integrator : packedIntegrators()) {
    SCOPED_TRACE(integrator);
    const test::Bench bench = thrownBodies(21);
    Simulation packed = bench.simulation(integrator, 0.01),
               singly = oneByOne(bench, integrator, 0.01);
    const auto both = [&](const auto& act) {
      act(packed);
      act(singly);
      expectSameBits(packed, singly);
      for (int i = 0; i < 10; ++i) {
        packed.step();
        singly.step();
      }
      expectSameBits(packed, singly);
    };
    both([](Simulation&) {});
    both([](Simulation& sim) { sim.applyWrench("a", pushOf(2, 0.12, 0.155)); });
    both([](Simulation& sim) { sim.applyWrench("b", turnOf(3, 0, 10)); });
    both([](Simulation& sim) { sim.applyWrench("b", pushOf(3, 0, 10)); });
    both([](Simulation& sim) { sim.clearWrenches(3); });
    both([](Simulation& sim) { sim.setState(20, sim.body(0)); });
    both([](Simulation& sim) {
      PointWrench linked = turnOf(5, 0, 0.72);
      linked.axes = 6;
      sim.applyWrench("c", linked);
    });
    both([](Simulation& sim) {
      MassProperties lighter = test::propertiesOf(sim.world().bodies[4]);
      lighter.mass *= 0.5;
      lighter.I_Bcm *= 0.25;
      sim.setMassProperties(4, lighter);
    });
    both([](Simulation& sim) { sim.setPresent(6, std::nullopt); });
    both([](Simulation& sim) { sim.setPresent(6, sim.body(0)); });
    both([](Simulation& sim) { sim.reset(false); });
    both([](Simulation& sim) { sim.reset(true); });
  }
}

TEST(PackedRuns, GoOnFromTheirStates) {
  for (const std::string& integrator : packedIntegrators()) {
    test::Bench bench = thrownBodies(11);
    bench.world.wrenches.push_back(pushOf(7, 0.033, 0.077));
    test::expectToGoOnTheSame(bench.simulation(integrator, 0.01), {0, 3, 5, 70});
    Simulation packed = bench.simulation(integrator, 0.01);
    packed.step(5);
    const State saved = packed.state();
    packed.step(20);
    Simulation again = packed;
    again.load(saved);
    again.step(20);
    for (std::size_t i = 0; i < 11; ++i)
      EXPECT_TRUE(test::sameBits(again.body(i), packed.body(i))) << integrator;
  }
}

TEST(PackedRuns, AreReadBetweenSteps) {
  for (const std::string& integrator : packedIntegrators()) {
    const test::Bench bench = thrownBodies(9);
    Simulation packed = bench.simulation(integrator, 0.01),
               singly = oneByOne(bench, integrator, 0.01);
    packed.step(7);
    singly.step(7);
    for (double t : {0.07, 0.074}) {
      const State a = packed.sample(t), b = singly.sample(t);
      const auto motions = packed.motions({3, 8}, t), alone = singly.motions({3, 8}, t);
      for (std::size_t i = 0; i < 9; ++i) EXPECT_TRUE(test::sameBits(a.bodies[i], b.bodies[i]));
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_TRUE(test::sameBits(motions[k].state, alone[k].state));
        EXPECT_EQ(motions[k].acceleration.w_dot_P, alone[k].acceleration.w_dot_P);
      }
    }
    std::vector<BodyState> bodies(2);
    packed.readBodies(bodies);
    ASSERT_EQ(bodies.size(), 9u);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_TRUE(test::sameBits(bodies[i], singly.body(i)));
  }
}

TEST(PackedRuns, EstimateTheSameError) {
  for (const std::string& integrator : packedIntegrators()) {
    const test::Bench bench = thrownBodies(9);
    Simulation packed = bench.simulation(integrator, 0.01),
               singly = oneByOne(bench, integrator, 0.01);
    packed.step(4);
    singly.step(4);
    packed.trackError();
    singly.trackError();
    packed.step(20);
    singly.step(20);
    EXPECT_GT(packed.errorEstimate().attitude, 0);
    EXPECT_EQ(packed.errorEstimate().attitude, singly.errorEstimate().attitude);
    EXPECT_EQ(packed.errorEstimate().position, singly.errorEstimate().position);
    expectSameBits(packed, singly);
  }
}

}  // namespace
}  // namespace rigid_body_sim
