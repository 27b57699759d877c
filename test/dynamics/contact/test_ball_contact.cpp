#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/totals.hpp>
#include <rigid_body_sim/mass/shapes.hpp>

#include "support/contact_benches.hpp"
#include "support/same_state.hpp"

/// Balls that touch one another.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::letTouch;
using test::motionAt;

std::size_t addFreeBall(Bench& bench, double radius, double mass, const BodyFrameMotion& motion) {
  const std::string name = "ball" + std::to_string(bench.world.bodies.size());
  return bench.add(makeBody(name, massProperties(Sphere{radius}, mass)), motion);
}

/// Two balls that meet off centre, both of them spinning.
Bench meetingBalls(const ContactParameters& parameters) {
  Bench bench;
  addFreeBall(bench, 0.1, 1, motionAt({-1, 0.03, 0}, {2, 0, 0.1}, {3, -10, 20}));
  addFreeBall(bench, 0.15, 3, motionAt({1, 0, 0}, {-1, 0.02, 0}, {0, 5, -7}));
  letTouch(bench, 0, 0.1, 1, 0.15, parameters);
  return bench;
}

TEST(Balls, KeepMomentumAndAngularMomentum) {
  for (const char* integrator : {"auto", "dop853"}) {
    const Bench bench = meetingBalls(contactOf(1e6, 1.5, 0.2, 0.5));
    Simulation sim = bench.simulation(integrator, 0.01);
    const Totals start = totalsOf(sim.world(), sim.state());
    int touches = 0;
    while (sim.time() < 1.5) {
      sim.step();
      touches += static_cast<int>(sim.contactEvents().size());
    }
    const Totals end = totalsOf(sim.world(), sim.state());
    EXPECT_EQ(touches, 2) << integrator;
    EXPECT_LT(end.energy, 0.95 * start.energy);
    EXPECT_NEAR((end.momentum - start.momentum).norm(), 0, 1e-13) << integrator;
    EXPECT_NEAR((end.angular_momentum - start.angular_momentum).norm(), 0, 1e-12) << integrator;
  }
}

// Head on and elastic: v₁' = ((m₁ − m₂) v₁ + 2 m₂ v₂)/(m₁ + m₂)
TEST(Balls, ReboundAsElasticOnesDo) {
  for (double step : {1e-3, 0.3}) {
    Bench bench;
    addFreeBall(bench, 0.1, 1, motionAt({-1, 0, 0}, {2, 0, 0}));
    addFreeBall(bench, 0.15, 3, motionAt({1, 0, 0}, {-1, 0, 0}));
    letTouch(bench, 0, 0.1, 1, 0.15, contactOf(1e6, 1.5, 0, 0.5));
    Simulation sim = test::simulationAt(bench, 1e-10, step);
    while (sim.time() < 1.5) sim.step();
    EXPECT_NEAR(sim.body(0).p_W.x(), (1 - 3) * 2.0 / 4 + 2 * 3 * -1.0 / 4, 1e-12) << step;
    // after it they fly by themselves
    EXPECT_EQ(sim.plans().size(), 2u);
    EXPECT_TRUE(sim.plans()[0].integrator.empty());
  }
}

// e of the reduced mass, by the same closed form.
TEST(Balls, ReturnTheRestitutionAskedFor) {
  Bench bench;
  addFreeBall(bench, 0.1, 1, motionAt({-0.5, 0, 0}, {2, 0, 0}));
  addFreeBall(bench, 0.15, 3, motionAt({0.5, 0, 0}, {-1, 0, 0}));
  letTouch(bench, 0, 0.1, 1, 0.15, contactOf(1e6, 1.5, dissipationForRestitution(0.6, 3), 0));
  Simulation sim = test::simulationAt(bench, 1e-10, 0.01);
  while (sim.time() < 0.6) sim.step();
  EXPECT_NEAR(sim.body(1).p_W.x() / 3 - sim.body(0).p_W.x(), 0.6 * 3, 1e-12);
}

TEST(Balls, BounceOffOneThatIsFixed) {
  Bench bench;
  addFreeBall(bench, 0.1, 1, motionAt({0, 0, 1}, {0, 0, -2}));
  addFreeBall(bench, 0.2, 1, motionAt({0, 0, 0}));
  bench.world.bodies[1].fixed = true;
  letTouch(bench, 0, 0.1, 1, 0.2, contactOf(1e6, 1, 0, 0.3));
  Simulation sim = test::simulationAt(bench, 1e-10, 0.01);
  while (sim.time() < 1) sim.step();
  EXPECT_NEAR(sim.body(0).p_W.z(), 2, 1e-12);
}

// One lies on the ground, integrated; the other falls on it.
TEST(Balls, FallOnOneThatLiesOnTheGround) {
  for (double step : {1e-3, 0.02}) {
    Bench bench;
    bench.world.g_W = {0, 0, -9.81};
    const ContactParameters c = contactOf(1e5, 1, 0.5, 0.3);
    test::addBall(bench, 0.2, 1, motionAt({0, 0, 0.2 - 9.81e-5}), HalfSpace{}, c);
    test::addBall(bench, 0.1, 0.2, motionAt({0, 0, 1.5}), HalfSpace{}, c);
    letTouch(bench, 0, 0.2, 1, 0.1, c);
    Simulation sim = bench.simulation("auto", step);
    std::vector<ContactEvent> between;
    while (sim.time() < 0.47) {
      sim.step();
      for (const ContactEvent& event : sim.contactEvents())
        if (event.other == 1) between.push_back(event);
    }
    ASSERT_EQ(between.size(), 2u) << step;
    // falls from 1.5 m to 0.5 m, less what the lower one yields
    EXPECT_NEAR(between[0].t, std::sqrt(2 * (1 + 9.81e-5) / 9.81), 1e-9) << step;
    EXPECT_GT(sim.body(1).p_W.z(), 0);
  }
}

TEST(Balls, GoOnFromAStateWithTheSameBits) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  const ContactParameters c = contactOf(1e5, 1.5, 0.5, 0.3);
  for (int i = 0; i < 3; ++i)
    test::addBall(bench, 0.1, 1, motionAt({0.02 * i, 0.01 * i, 0.15 + 0.25 * i}), HalfSpace{}, c);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a + 1; b < 3; ++b) letTouch(bench, a, 0.1, b, 0.1, c);
  std::vector<std::int64_t> cuts;
  for (int cut = 30; cut <= 300; cut += 30) cuts.push_back(cut);
  test::expectToGoOnTheSame(bench.simulation("auto", 2e-3), cuts);
}

}  // namespace
}  // namespace rigid_body_sim
