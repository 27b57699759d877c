#include <gtest/gtest.h>

#include "dynamics/run/run.hpp"
#include "support/many_bodies.hpp"
#include "support/packed_beside_single.hpp"
#include "support/random_bodies.hpp"
#include "support/same_state.hpp"

// Bodies with torques and with forces in their own axes, stepped in packs, beside the same runs
// while the balance is tracked: then each body is stepped by itself.

namespace rigid_body_sim {
namespace {

using test::packedIntegrators;

/// Every body is pushed, each in one of six ways; body 5 and every sixth after it at two points,
/// which no pack takes.
test::Bench pushedBodies(std::size_t count, double end) {
  test::Bench bench = test::thrownBodies(count);
  Draw draw(11);
  for (std::size_t i = 0; i < count; ++i) {
    PointWrench push = test::worldForce({0, 0, 0}, 0, end);
    push.body = push.point_frame = i;
    if (i % 6 != 0) push.force = draw.vector(1);
    if (i % 6 == 0 || i % 6 == 3) push.torque = draw.vector(0.1);
    if (i % 6 > 1) push.point = draw.vector(0.1);
    if (i % 6 == 4) push.axes = i;
    bench.world.wrenches.push_back(push);
    if (i % 6 != 5) continue;
    push.point = draw.vector(0.1);
    bench.world.wrenches.push_back(push);
  }
  return bench;
}

TEST(PackedPushes, AreInPacks) {
  for (const std::string& integrator : packedIntegrators()) {
    World world = pushedBodies(24, 1).world;
    world.solver.integrator = integrator;
    world.solver.time_step = 0.01;
    rigid_body_sim::Run run(std::make_shared<const World>(world),
                            std::make_shared<const State>(pushedBodies(24, 1).initial));
    run.step();
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(run.now().packs.holds(i), i % 6 != 5) << i;
  }
}

TEST(PackedPushes, HaveTheBitsOfBodiesByThemselves) {
  for (const std::string& integrator : packedIntegrators())
    for (std::size_t count : {1u, 2u, 5u, 41u}) {
      SCOPED_TRACE(integrator + ", bodies: " + std::to_string(count));
      test::expectSameAsSingly(pushedBodies(count, 0.777), integrator, 150);
    }
}

TEST(PackedPushes, SpinUpBodiesUntilStepsAreDivided) {
  for (const std::string& integrator : packedIntegrators()) {
    test::Bench bench = test::thrownBodies(10);
    for (std::size_t i = 0; i < 10; i += 2) {
      PointWrench turn = test::worldForce({0, 0, 0}, 0, 10);
      turn.body = turn.point_frame = i;
      turn.axes = i % 4 == 0 ? kWorld : i;
      turn.torque = Vector3d(20, 30, -10) * static_cast<double>(i + 1);
      bench.world.wrenches.push_back(turn);
    }
    test::expectSameAsSingly(bench, integrator, 150);
    Simulation simulation = bench.simulation(integrator, 0.01);
    simulation.step(150);
    EXPECT_GT(simulation.maxSubsteps(), 1) << integrator;
  }
}

TEST(PackedPushes, KeepTheSignsOfZeros) {
  for (const std::string& integrator : packedIntegrators())
    for (double zero : {0.0, -0.0}) {
      test::Bench bench = test::restingBodies(6, zero);
      for (std::size_t i = 0; i < 6; ++i) {
        PointWrench push = test::worldForce({zero, zero, zero}, 0, 10);
        push.body = push.point_frame = i;
        if (i % 2 == 1) push.axes = i;
        push.torque = {zero, i < 3 ? 0.1 : -0.1, zero};
        push.force = {zero, zero, i % 3 == 0 ? 1 : zero};
        push.point = {zero, i % 3 == 0 ? 0.1 : zero, zero};
        bench.world.wrenches.push_back(push);
      }
      test::expectSameAsSingly(bench, integrator, 3);
    }
}

TEST(PackedPushes, ChangeBetweenSteps) {
  for (const std::string& integrator : packedIntegrators()) {
    const test::Bench bench = pushedBodies(14, 100);
    test::PackedBesideSingle both(bench, integrator);
    both([](Simulation& sim) { sim.clearWrenches(3); });
    both([](Simulation& sim) { sim.clearWrenches(4); });
    both([](Simulation& sim) {
      PointWrench turn = test::worldForce({1, 2, 3}, 0, 100);
      turn.body = turn.point_frame = 3;
      turn.point = {0.1, 0, 0};
      sim.applyWrench("a", turn);
    });
    both([](Simulation& sim) { sim.setState(9, sim.body(0)); });
    both([](Simulation& sim) { sim.reset(true); });
  }
}

}  // namespace
}  // namespace rigid_body_sim
