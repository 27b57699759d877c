#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/worlds.hpp"

/// A body that drag brings ever closer to the centre of a force, about which it turns ever faster.
namespace rigid_body_sim {
namespace {

/// On a circle of 5e-5 m about a centre of 1 m³/s²: 4500 turns in a step of 10 ms, in each of which
/// every component of the velocity changes its sign twice, where drag has a kink.
Simulation spiralling(const std::string& integrator) {
  constexpr double kMu = 1, kRadius = 5e-5;
  test::Bench bench;
  BodyFrameMotion motion;
  motion.x_W = {kRadius, 0, 0};
  motion.v_W = {0, std::sqrt(kMu / kRadius), 0};
  bench.add(test::principalBody("ball", 1, {0.004, 0.004, 0.004}), motion);
  bench.addCentralGravity(0, Vector3d::Zero(), kMu, false);
  MediumDrag::Coefficients drag;
  drag.quadratic.axes = {1, 2, 3};
  bench.addMediumDrag(0, drag, Vector3d::Zero());
  bench.world.solver.horizon = 0.01;
  return bench.simulation(integrator, 0.01);
}

}  // namespace

// the count of events alone, each of which takes a thousand evaluations, would stop it much later
TEST(SpiralIntoACentre, EndsInOneLineAfterBoundedWork) {
  Simulation sim = spiralling("dop853");
  try {
    sim.step();
    FAIL() << "was followed";
  } catch (const SimulationDiverged& diverged) {
    EXPECT_EQ(
        std::string(diverged.what()),
        "t = 0 s: body 'ball': to end at its events, a step takes more than 10000000 "
        "evaluations of the forces: what meets ever more of them, such as a body that drag brings "
        "into the centre of a force, cannot be followed; else take a shorter time_step");
  }
  EXPECT_TRUE(sim.state().bodies[0].x_W.allFinite());
}

}  // namespace rigid_body_sim
