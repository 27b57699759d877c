#include <gtest/gtest.h>

#include "dynamics/run/run.hpp"
#include "support/many_bodies.hpp"
#include "support/packed_beside_single.hpp"
#include "support/random_bodies.hpp"
#include "support/same_state.hpp"

// Bodies with drag, stepped in packs, beside the same runs while the balance is tracked: then each
// body is stepped by itself.

namespace rigid_body_sim {
namespace {

using test::packedIntegrators;

Drag::Coefficients randomDrag(std::size_t i, Draw& draw) {
  Drag::Coefficients drag;
  if (i % 4 != 0) drag.linear = draw.uniform(0, 2);
  if (i % 2 == 0) drag.quadratic = draw.uniform(0, 1);
  if (i % 3 != 0) drag.angular = draw.uniform(0, 0.1);
  return drag;
}

/// Bodies with drag of every kind, every third without; every fifth is pushed, too.
test::Bench draggedBodies(std::size_t count) {
  test::Bench bench = test::thrownBodies(count);
  Draw draw(13);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 3 != 2) bench.addDrag(i, randomDrag(i, draw));
    if (i % 5 != 0) continue;
    PointWrench push = test::worldForce(draw.vector(1), 0, 0.777);
    push.body = push.point_frame = i;
    if (i % 10 == 0) push.point = draw.vector(0.1);
    bench.world.wrenches.push_back(push);
  }
  return bench;
}

TEST(PackedDrag, IsInPacks) {
  for (const std::string& integrator : packedIntegrators()) {
    const test::Bench bench = draggedBodies(24);
    World world = bench.world;
    world.solver.integrator = integrator;
    world.solver.time_step = 0.01;
    rigid_body_sim::Run run(std::make_shared<const World>(world),
                            std::make_shared<const State>(bench.initial));
    run.step();
    EXPECT_EQ(run.now().packs.size(), 24u);
  }
}

TEST(PackedDrag, HasTheBitsOfBodiesByThemselves) {
  for (const std::string& integrator : packedIntegrators())
    for (std::size_t count : {1u, 3u, 50u}) {
      SCOPED_TRACE(integrator + ", bodies: " + std::to_string(count));
      test::expectSameAsSingly(draggedBodies(count), integrator, 150);
    }
}

TEST(PackedDrag, DividesStepsOfFastBodiesAsEver) {
  for (const std::string& integrator : packedIntegrators()) {
    test::Bench bench = test::thrownBodies(12);
    for (std::size_t i = 0; i < 12; ++i) {
      const double share = 0.25 * static_cast<double>(i + 1) * 100;  // of a step, 0.25 to 3
      const double mass = bench.world.bodies[i].mass;
      const double speed = bench.initial.bodies[i].p_W.norm() / mass;
      if (i % 3 == 0) bench.addDrag(i, {share * mass, 0, 0});
      if (i % 3 == 1) bench.addDrag(i, {0, share * mass / (2 * speed), 0});
      if (i % 3 == 2) bench.addDrag(i, {0, 0, share * bench.world.bodies[i].I[0]});
    }
    test::expectSameAsSingly(bench, integrator, 100);
    Simulation simulation = bench.simulation(integrator, 0.01);
    simulation.step();
    EXPECT_GT(simulation.maxSubsteps(), 1) << integrator;
  }
}

TEST(PackedDrag, GoesOnFromAStateAndInAChangedWorld) {
  for (const std::string& integrator : packedIntegrators()) {
    const test::Bench bench = draggedBodies(14);
    test::expectToGoOnTheSame(bench.simulation(integrator, 0.01), {0, 3, 70});
    test::PackedBesideSingle both(bench, integrator);
    both([](Simulation& sim) { sim.setPresent(3, std::nullopt); });
    both([](Simulation& sim) { sim.setPresent(3, sim.body(0)); });
    both([](Simulation& sim) { sim.setState(9, sim.body(0)); });
    both([](Simulation& sim) { sim.reset(true); });
  }
}

}  // namespace
}  // namespace rigid_body_sim
