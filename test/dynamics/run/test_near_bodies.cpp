#include <gtest/gtest.h>

#include <rigid_body_sim/mass/shapes.hpp>

#include "support/contact_benches.hpp"
#include "support/law_benches.hpp"
#include "support/worlds.hpp"

/// Bodies that are integrated together because they are near each other.
namespace rigid_body_sim {

// a ball that has no wrench itself is integrated all the same, together with the body that a wrench
// pushes in the ball's axes
TEST(NearBodies, MayBeIntegratedForAWrenchOnAnotherBody) {
  test::Bench bench;
  bench.world.solver.tolerance = 1e-6;
  const Body left = makeBody("left", massProperties(Sphere{0.1}, 1));
  const Body right = makeBody("right", massProperties(Sphere{0.1}, 1));
  bench.add(left, test::motionAt({0, 0, 0}, {0.5, 0, 0}));
  bench.add(right, test::motionAt({0.25, 0, 0}, {-0.5, 0, 0}));
  bench.add(test::principalBody("pushed", 2, {1, 2, 2.5}), test::motionAt({9, 0, 0}));
  bench.world.laws.push_back(contactOfBalls(bench.world.bodies, 0, test::ballShape(0.1), 1,
                                            test::ballShape(0.1), test::contactOf(1e4, 1.5, 0, 0)));
  PointWrench push = test::worldForce({1, 0, 0}, 0, 9);
  push.body = 2;
  push.axes = 0;
  bench.world.wrenches.push_back(push);
  Simulation sim = bench.simulation("auto", 0.01);
  while (sim.steps() < 20) sim.step();
  // they have bounced off each other without loss
  EXPECT_NEAR(sim.body(0).p_W.x(), -0.5, 1e-6);
  EXPECT_NEAR(sim.body(1).p_W.x(), 0.5, 1e-6);
}

}  // namespace rigid_body_sim
