#include <cmath>

#include <gtest/gtest.h>

#include "support/contact_benches.hpp"
#include "support/motor_benches.hpp"

/// Motors of bodies that touch.
namespace rigid_body_sim {
namespace {

using namespace test;

constexpr double kRadius = 0.1, kMass = 2;

/// A ball with a thruster through its centre, upwards, above the plane z = 0.
Bench jumpingBall(double gap, double time_constant) {
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  const std::size_t ball = addBall(bench, kRadius, kMass, motionAt({0, 0, kRadius + gap}),
                                   HalfSpace(), contactOf(1e5, 1.5, 20, 0));
  bench.world.bodies[ball].actuators = {
      named("jet", thrusterAt({0, 0, 0}, {0, 0, 1}, time_constant))};
  return bench;
}

}  // namespace

// gap = ½ (g + F/m) t²: the bound on how soon a body in flight may touch knows of its motors.
TEST(MotorContact, PushedDownItTouchesAtItsInstantWhateverTheStep) {
  const double F = 60, t = std::sqrt(2 * 0.5 / (10 + F / kMass));
  for (const double step : {0.01, 0.3}) {
    Bench bench = jumpingBall(0.5, 0);
    bench.world.commands = {commandOf(0, -F, 0)};
    Simulation sim = simulationAt(bench, 1e-9, step);
    std::vector<ContactEvent> events;
    while (events.empty() && sim.time() < 1) {
      sim.step();
      events = sim.contactEvents();
    }
    ASSERT_FALSE(events.empty()) << step;
    EXPECT_NEAR(events[0].t, t, 1e-12) << step;
  }
}

// At rest k δ^1.5 = m g − e; with more thrust than weight it takes off, and flies solved.
TEST(MotorContact, RestsUnderPartOfItsWeightThenTakesOff) {
  Bench bench = jumpingBall(0, 0.05);
  bench.world.commands = {commandOf(0, 12, 0), commandOf(0, 30, 4)};
  Simulation sim = simulationAt(bench, 1e-9, 0.01);
  while (sim.time() < 4) sim.step();
  const double depth = std::pow((kMass * 10 - 12) / 1e5, 1 / 1.5);
  EXPECT_NEAR(kRadius - sim.body(0).x_W.z(), depth, 1e-6);
  while (sim.time() < 5) sim.step();
  EXPECT_EQ(sim.plans()[0].integrator, "");
  EXPECT_GT(sim.body(0).x_W.z(), 1);
  const Vector3d p = sim.body(0).p_W;
  while (sim.time() < 6) sim.step();
  EXPECT_NEAR((sim.body(0).p_W - p).z(), 30 - kMass * 10, 1e-6);
}

// Motors that do nothing leave a body at rest; a command wakes it at its instant.
TEST(MotorContact, IdleMotorsLeaveABodyAtRest) {
  Simulation sim = simulationAt(jumpingBall(0, 0), 1e-6, 0.01);
  while (sim.time() < 3 && !sim.plans()[0].at_rest) sim.step();
  ASSERT_TRUE(sim.plans()[0].at_rest);
  const double t = sim.time() + 0.123;
  sim.command(commandOf(0, 30, t));
  while (sim.time() < t + 1) sim.step();
  EXPECT_NEAR(sim.body(0).p_W.z(), (30 - kMass * 10) * (sim.time() - t),
              1);  // and what springs back
  const double p = sim.body(0).p_W.z();
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_NEAR(sim.body(0).p_W.z() - p, 30 - kMass * 10, 1e-12 * p);
}

}  // namespace rigid_body_sim
