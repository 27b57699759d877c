#include <limits>

#include <gtest/gtest.h>

#include "dynamics/run/run.hpp"
#include "support/many_bodies.hpp"
#include "support/random_bodies.hpp"
#include "support/same_bits.hpp"

// What is not plainly fit for a pack goes the way of a body by itself, whatever becomes of it.

namespace rigid_body_sim {
namespace {

using test::packedIntegrators;

void expectSameEnd(const test::Bench& bench, const std::string& integrator, double h, int steps) {
  Simulation packed = bench.simulation(integrator, h), singly = bench.simulation(integrator, h);
  singly.trackBalance();
  const auto end = [steps](Simulation& simulation) -> std::string {
    try {
      for (int i = 0; i < steps; ++i) simulation.step();
    } catch (const SimulationDiverged& diverged) {
      return diverged.what();
    }
    return "";
  };
  const std::string message = end(packed);
  EXPECT_EQ(message, end(singly)) << integrator;
  if (message.empty()) return test::expectSameBits(packed, singly);
  test::expectSameBodies(packed, singly);  // what a step counts before it is taken back differs
}

TEST(PackedExtremes, FastBodiesAreDividedAsEver) {
  for (const std::string& integrator : packedIntegrators())
    for (double w : {10.0, 38.0, 41.0, 79.0, 81.0, 300.0}) {
      test::Bench bench = test::thrownBodies(8);
      Draw draw(5);
      for (std::size_t i = 0; i < 8; i += 3)
        bench.initial.bodies[i] = draw.state(bench.world.bodies[i], w);
      expectSameEnd(bench, integrator, 0.01, 100);
    }
}

TEST(PackedExtremes, NeedlesAndPlatesKeepTheirBits) {
  test::Bench bench;
  Draw draw(7);
  for (std::size_t i = 0; i < 30; ++i) {
    Body body = draw.box(1 + static_cast<double>(i) / 10);
    body.name = "box" + std::to_string(i);
    bench.initial.bodies.push_back(draw.state(body, 1));
    bench.world.bodies.push_back(body);
  }
  for (const std::string& integrator : packedIntegrators())
    expectSameEnd(bench, integrator, 1e-3, 100);
}

TEST(PackedExtremes, RestingBodiesKeepTheSignsOfTheirZeros) {
  for (const std::string& integrator : packedIntegrators())
    for (double zero : {0.0, -0.0}) {
      test::Bench bench = test::restingBodies(6, zero);
      bench.initial.bodies[3].L_P = {0, 1, zero};
      bench.initial.bodies[3].L_W = {zero, 1, 0};
      expectSameEnd(bench, integrator, 0.01, 3);
    }
}

TEST(PackedExtremes, WhatDivergesIsNamedAndNobodyElseIsTouched) {
  for (const std::string& integrator : packedIntegrators()) {
    test::Bench bench = test::thrownBodies(12);
    PointWrench push = test::worldForce({0, 0, 1e308}, 0.05, 10);
    push.body = push.point_frame = 7;
    bench.world.wrenches.push_back(push);
    bench.initial.bodies[7].p_W = {0, 0, 1e308};
    bench.world.solver.time_step = 0.01;
    expectSameEnd(bench, integrator, 0.01, 300);
    Simulation packed = bench.simulation(integrator, 0.01);
    std::string message;
    try {
      packed.step(300);
    } catch (const SimulationDiverged& diverged) {
      message = diverged.body;
    }
    EXPECT_EQ(message, "body7");
    Simulation singly = bench.simulation(integrator, 0.01);
    singly.trackBalance();
    singly.step(packed.steps());
    test::expectSameBodies(packed, singly);
  }
}

TEST(PackedExtremes, GreatNumbersStayOut) {
  test::Bench bench = test::thrownBodies(4);
  bench.initial.bodies[2].x_W = {1e70, 0, 0};
  bench.world.solver.integrator = "strang";
  bench.world.solver.time_step = 0.01;
  rigid_body_sim::Run run(std::make_shared<const World>(bench.world),
                          std::make_shared<const State>(bench.initial));
  run.step();
  EXPECT_EQ(run.now().packs.size(), 3u);
  EXPECT_FALSE(run.now().packs.holds(2));
}

}  // namespace
}  // namespace rigid_body_sim
