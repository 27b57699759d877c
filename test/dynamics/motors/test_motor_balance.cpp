#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/motor_benches.hpp"

/// What motors keep: angular momentum to the last bit, energy up to their work.
namespace rigid_body_sim {
namespace {

using namespace test;

Bench satelliteOnWheels() {
  reference::MotorBody satellite;
  satellite.properties_B = {10, Vector3d::Zero(), Vector3d(0.4, 0.5, 0.6).asDiagonal()};
  satellite.actuators = {named("x", wheelAlong({1, 0, 0}, 0.01), 0.2),
                         named("y", wheelAlong({0, 1, 0}, 0.01), 0.2),
                         named("z", wheelAlong({0, 0, 1}, 0.01), 0.2)};
  return benchOf(satellite, tumbling({0, 0, 0}, {0.3, -0.2, 0.1}));
}

}  // namespace

// The same over 1e6 steps is measured: test/benchmark/motors.cpp.
TEST(MotorBalance, WheelsLeaveAngularMomentumAtItsLastBit) {
  Simulation sim = satelliteOnWheels().simulation("auto", 0.01);
  const Vector3d L_W = sim.body(0).L_W;
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> torque(-0.2, 0.2);
  for (int i = 0; i < 20000; ++i) {
    sim.command(commandOf(static_cast<std::size_t>(i % 3), torque(draw), sim.time()));
    sim.step();
    ASSERT_EQ(sim.body(0).L_W, L_W) << i;
  }
  // and the body turns as L_W and the wheels say
  const Body& body = sim.world().bodies[0];
  const BodyState state = sim.body(0);
  Vector3d H_B = Vector3d::Zero();
  const Vector3d w_B = body.X_BP.linear() * angularVelocity(body.inv_I, state.L_P);
  const auto readings = sim.actuators(0);
  for (int k = 0; k < 3; ++k)
    H_B[k] = 0.01 * (readings[static_cast<std::size_t>(k)].speed + w_B[k]);
  const Vector3d L_P = rotateBack(state.q_WP, L_W) - body.X_BP.linear().transpose() * H_B;
  EXPECT_LE((state.L_P - L_P).norm(), 1e-12);
}

TEST(MotorBalance, EnergyChangesByTheWorkOfMotorsAndAir) {
  for (const char* integrator : {"auto", "taylor"}) {
    Bench bench = benchOf(motley(), motleyStart());
    bench.world.commands = {commandOf(0, 8, 0),      commandOf(1, -40, 0.1234567),
                            commandOf(2, 0.3, 0.2),  commandOf(3, -0.1, 0.25),
                            commandOf(0, -3, 0.777), commandOf(2, -0.5, 1.0001)};
    Simulation sim = bench.simulation(integrator, 0.01);
    sim.trackBalance();
    double work = 0;
    for (int i = 0; i < 200; ++i) {
      sim.step();
      work = std::max(work, std::abs(sim.exchanged().energy));
    }
    EXPECT_GT(work, 10) << integrator;
    EXPECT_LE(std::abs(sim.balance().energy), 1e-12 * work) << integrator;
    EXPECT_LE(sim.balance().momentum.norm(), 1e-12) << integrator;
    EXPECT_LE(sim.balance().angular_momentum.norm(), 1e-12) << integrator;
  }
}

TEST(MotorBalance, IntegratorsLeaveTheirOwnErrorOnly) {
  Bench bench = benchOf(motley(), motleyStart());
  bench.world.commands = {commandOf(0, 8, 0), commandOf(1, 40, 0.1), commandOf(2, 0.3, 0.2)};
  double last = 1;
  for (int steps : {100, 200, 400}) {
    Simulation sim = bench.simulation("rk4", 1. / steps);
    sim.trackBalance();
    for (int i = 0; i < steps; ++i) sim.step();
    const double rest = std::abs(sim.balance().energy);
    EXPECT_LT(rest, last / 12) << steps;  // 16 for fourth order
    last = rest;
  }
}

// ½ J Ω² + ½ I ω² of a rotor that its motor brakes: what the motor took, none of it lost
TEST(MotorBalance, TotalsCountRotorsAndWheels) {
  Rotor rotor = rotorAt({0, 0, 0}, 1, 0.02);
  rotor.speed = 50;
  const reference::MotorBody motors{
      {2, Vector3d::Zero(), Vector3d(1, 2, 3).asDiagonal()},
      {named("rotor", rotor), named("wheel", wheelAlong({0, 0, 1}, 0.1, 7))},
      Vector3d::Zero()};
  const Bench bench = benchOf(motors, tumbling({0, 0, 0}, {0, 0, 2}));
  const Simulation sim = bench.simulation("auto", 0.1);
  const Totals totals = totalsOf(sim.world(), sim.state());
  const double spin = 0.5 * (3 - 0.02 - 0.1) * 4 + 0.5 * 0.02 * 52 * 52 + 0.5 * 0.1 * 81;
  EXPECT_NEAR(totals.energy, spin, 1e-13);
  EXPECT_NEAR(totals.angular_momentum.z(), 3 * 2 + 0.02 * 50 + 0.1 * 7, 1e-14);
  EXPECT_EQ(totalsOf(sim.world(), bench.initial).energy, totals.energy);
}

}  // namespace rigid_body_sim
