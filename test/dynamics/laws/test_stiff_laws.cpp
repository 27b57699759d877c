#include <cmath>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "support/counted_law.hpp"
#include "support/law_benches.hpp"

/// Laws whose rates no step of the scene follows, and laws in great number.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::CountedLaw;
using test::principalBody;
using test::tumbling;

std::vector<std::string> integratorsThatSupport(unsigned needs) {
  std::vector<std::string> names{"auto"};
  for (const Method& method : catalogue())
    if (method.supports(needs)) names.push_back(method.name);
  return names;
}

constexpr double kStep = 0.01;  // [s]

/// Auto is to hold its tolerance over the first steps.
Simulation simulationOf(Bench bench, const std::string& integrator) {
  bench.world.solver.horizon = 0.3;
  return bench.simulation(integrator, kStep);
}

/// Steps for 0.3 s; every state must be finite and no faster than before.
State slowedDown(const Bench& bench, const std::string& integrator) {
  Simulation sim = simulationOf(bench, integrator);
  double v = bench.initial.bodies[0].p_W.norm(), L = bench.initial.bodies[0].L_P.norm();
  for (int i = 0; i < 30; ++i) {
    sim.step();
    const BodyState& s = sim.body(0);
    // to the rounding of a velocity that has come to rest
    EXPECT_LE(s.p_W.norm(), v * (1 + 1e-12)) << integrator << " step " << i;
    EXPECT_LE(s.L_P.norm(), L * (1 + 1e-12)) << integrator << " step " << i;
    v = s.p_W.norm();
    L = s.L_P.norm();
  }
  return sim.state();
}

// c h/m = 300: the body stops after m v/c, within a step's way of its start.
TEST(StiffDrag, StopsTheBodyUnderEveryIntegratorThatSupportsIt) {
  constexpr double m = 2, c = 300 * m / kStep;
  const Vector3d v(3, -1, 2), w(1, 2, 3);
  for (const std::string& integrator : integratorsThatSupport(kDrag)) {
    for (const Drag::Coefficients& drag : {Drag::Coefficients{c, 0, c}, {c, c, c}}) {
      Bench bench;
      bench.add(principalBody("body", m, {1, 2, 2.5}), tumbling(v, w));
      bench.addDrag(0, drag);
      const BodyState end = slowedDown(bench, integrator).bodies[0];
      EXPECT_LE(end.p_W.norm(), 1e-15) << integrator;
      EXPECT_LE(end.L_P.norm(), 1e-15) << integrator;
      EXPECT_LE(end.x_W.norm(), v.norm() * kStep) << integrator;
      EXPECT_LE(angleBetween(end.q_WP, Quaterniond::Identity()), w.norm() * kStep) << integrator;
    }
  }
}

// Falling at m g/c or √(m g/c) from the second step on.
TEST(StiffDrag, LetsTheBodySinkAtItsTerminalVelocity) {
  constexpr double m = 2, c = 300 * m / kStep, g = 9.81;
  for (const std::string& integrator : integratorsThatSupport(kDrag)) {
    for (bool quadratic : {false, true}) {
      Bench bench;
      bench.world.g_W = {0, 0, -g};
      bench.add(principalBody("body", m, {1, 2, 2.5}), BodyFrameMotion());
      bench.addDrag(0, quadratic ? Drag::Coefficients{0, c, 0} : Drag::Coefficients{c, 0, 0});
      const double v = quadratic ? std::sqrt(m * g / c) : m * g / c;
      Simulation sim = simulationOf(bench, integrator);
      while (sim.steps() < 30) sim.step();
      const BodyState end = sim.body(0);
      EXPECT_NEAR(end.p_W.z() / m, -v, 1e-9 * v) << integrator << quadratic;
      EXPECT_NEAR(end.x_W.z(), -0.3 * v, 2 * kStep * v) << integrator << quadratic;
    }
  }
}

/// A body hung on a spring of 1e6 N/m, pulled down by 1 cm; ωh = 7.
Bench stiffSpring(double damping) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  BodyFrameMotion motion;
  motion.x_W = {0, 0, -1.01};
  bench.add(principalBody("weight", 2, {1, 2, 2.5}), motion);
  bench.addSpring({kWorld, Vector3d::Zero()}, {0, Vector3d::Zero()}, {1e6, damping, 1});
  return bench;
}

// From a damping ratio of 0.07 to 7; it ends m g/k below the length of rest.
TEST(StiffSpring, ComesToRestUnderEveryIntegratorThatSupportsIt) {
  for (double damping : {2e2, 2e3, 2e4}) {
    const Bench bench = stiffSpring(damping);
    const double E_0 = mechanicalEnergy(bench.world, bench.initial);
    for (const std::string& integrator : integratorsThatSupport(kCoupling | kDamping)) {
      Simulation sim = simulationOf(bench, integrator);
      for (int i = 0; i < 300; ++i) {
        sim.step();
        EXPECT_LE(mechanicalEnergy(bench.world, sim.state()), E_0) << integrator << " " << damping;
      }
      const BodyState end = sim.body(0);
      EXPECT_NEAR(end.x_W.z(), -1 - 2 * 9.81 / 1e6, 1e-9) << integrator << " " << damping;
      EXPECT_LE(end.p_W.norm(), 1e-8) << integrator << " " << damping;
    }
  }
}

// At 0.8 rad a step the update of first order swings in energy by ωh/2; it must not grow.
TEST(StiffSpring, KeepsSwingingUnderEveryIntegratorThatSupportsIt) {
  const Bench bench = stiffSpring(0);
  const double E_rest = -2 * 9.81;  // hanging still, but for the m g/k of its stretch
  const double E_0 = mechanicalEnergy(bench.world, bench.initial) - E_rest;
  for (const std::string& integrator : integratorsThatSupport(kCoupling)) {
    Simulation sim = simulationOf(bench, integrator);
    for (int i = 0; i < 300; ++i) sim.step();
    const double E = mechanicalEnergy(bench.world, sim.state()) - E_rest;
    EXPECT_LT(E, 1.7 * E_0) << integrator;
    if (integrator == "rk4") continue;  // damps by (ωh)⁶/72 a step
    EXPECT_GT(E, 0.5 * E_0) << integrator;
  }
}

/// Balls in a row, a metre apart, each linked to the next.
Bench chain(std::size_t balls, std::int64_t& count) {
  Bench bench;
  for (std::size_t i = 0; i < balls; ++i) {
    BodyFrameMotion motion = tumbling({0, 0, i == 0 ? 1.0 : 0.0}, {0, 1, 0});
    motion.x_W = {static_cast<double>(i), 0, 0};
    bench.add(principalBody("ball" + std::to_string(i), 1, {0.1, 0.1, 0.1}), motion);
    if (i == 0) continue;
    const auto spring =
        std::make_shared<Spring>(Spring::End{i - 1, {0.3, 0, 0}}, Spring::End{i, {-0.3, 0, 0}},
                                 Spring::Constants{100, 0, 0.4});
    bench.world.laws.push_back(std::make_shared<CountedLaw>(spring, count));
  }
  return bench;
}

// strang follows 0.8 rad a substep; a rod in the gradient swings √3 times as fast as it orbits.
TEST(CentralGravity, DividesAStepThatIsLongBesideTheOrbit) {
  for (const double radius : {0.5, 2.0}) {
    for (const bool gradient : {false, true}) {
      constexpr double kTurn = 3;  // [rad] of a circular orbit in a step of 1 s
      Bench bench;
      BodyFrameMotion motion = tumbling({0, kTurn * radius, 0}, {0, 0, 0});
      motion.x_W = {radius, 0, 0};
      bench.add(principalBody("moon", 1, {1, 1, 1}), motion);
      bench.addCentralGravity(0, {0, 0, 0}, kTurn * kTurn * std::pow(radius, 3), gradient);
      Simulation sim = bench.simulation("strang", 1);
      sim.step();
      EXPECT_EQ(sim.maxSubsteps(), gradient ? 7 : 4) << radius;  // 3 / 0.8, and 3 √3 / 0.8
    }
  }
}

TEST(Chain, OfAThousandBodiesAsksEachSpringOnceAnEvaluation) {
  for (std::size_t balls : {10u, 1000u}) {
    std::int64_t count = 0;
    const Bench bench = chain(balls, count);
    Simulation sim = bench.simulation("strang", 1e-3);
    ASSERT_EQ(sim.plans().size(), 1u);
    for (int i = 0; i < 20; ++i) sim.step();
    EXPECT_EQ(sim.evaluations(), 21);
    EXPECT_EQ(count, 21 * static_cast<std::int64_t>(balls - 1));
    // what the first ball brought, shared out and none lost
    Vector3d p = Vector3d::Zero();
    for (const BodyState& s : sim.state().bodies) p += s.p_W;
    EXPECT_LE((p - Vector3d(0, 0, 1)).norm(), 1e-13);
    EXPECT_LT(sim.body(0).p_W.z(), 1);
  }
}

TEST(Chain, FallsApartIntoGroupsWhereItIsCut) {
  std::int64_t count = 0;
  Bench bench = chain(10, count);
  bench.world.laws.erase(bench.world.laws.begin() + 4);
  EXPECT_EQ(bench.simulation("strang", 1e-3).plans().size(), 2u);
}

}  // namespace
}  // namespace rigid_body_sim
