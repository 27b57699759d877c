#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "support/breaking_spring.hpp"
#include "support/maxwell_element.hpp"
#include "support/same_state.hpp"
#include "support/worlds.hpp"

/// Laws with states of their own and events.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::BreakingSpring;
using test::principalBody;
using test::tumbling;

constexpr double kMass = 2, kStiffness = 50, kSpeed = 3, kLimit = 20;

/// A ball that flies off along x, held back by a spring from the world's origin until that breaks.
Bench tetheredBall() {
  Bench bench;
  bench.add(principalBody("ball", kMass, {0.1, 0.1, 0.1}), tumbling({kSpeed, 0, 0}, {0, 0, 1}));
  bench.world.laws.push_back(std::make_shared<BreakingSpring>(
      Spring::End{kWorld, Vector3d::Zero()}, Spring::End{0, Vector3d::Zero()}, kStiffness, kLimit));
  return bench;
}

/// x = v/ω sin ωt until k x = limit, then on at the speed that is left.
struct Broken {
  double t, x, v;  ///< [s], [m], [m/s] at the instant of breaking
};
Broken breaking() {
  const double w = std::sqrt(kStiffness / kMass), x = kLimit / kStiffness;
  const double t = std::asin(w * x / kSpeed) / w;
  return {t, x, kSpeed * std::cos(w * t)};
}

std::vector<std::string> supporting(unsigned needs) {
  std::vector<std::string> names{"auto"};
  for (const Method& method : catalogue())
    if (method.supports(needs)) names.push_back(method.name);
  return names;
}

// An event inside a step costs no order: errors fall as those of a spring that holds.
TEST(BreakingSpring, BreaksAtItsInstantUnderEveryIntegrator) {
  const Broken broken = breaking();
  const double x_end = broken.x + broken.v * (1 - broken.t);
  for (const std::string& name : supporting(kCoupling)) {
    std::vector<double> errors;
    for (int steps : {100, 200}) {
      const State end = tetheredBall().run(name, 1, steps);
      EXPECT_EQ(end.laws, std::vector<double>{0}) << name;
      errors.push_back(std::abs(end.bodies[0].x_W.x() - x_end));
    }
    if (name == "auto") {
      EXPECT_LT(errors[0], 1e-9) << name;
      continue;
    }
    // h^order of the frequency of 5 rad/s over 1 s, and rounding of the event's instant
    const int order = methodNamed(name).order;
    EXPECT_LT(errors[0], std::pow(5 * 0.01, order) + 1e-13) << name;
    if (errors[1] > 1e-13) {
      EXPECT_GT(errors[0] / errors[1], std::exp2(order) / 1.5) << name;
    }
  }
}

TEST(BreakingSpring, LeavesItsBodyToBeSolved) {
  Simulation sim = tetheredBall().simulation("auto", 0.01);
  EXPECT_FALSE(sim.plans()[0].integrator.empty());
  while (sim.steps() < 100) sim.step();
  ASSERT_EQ(sim.plans().size(), 1u);
  EXPECT_TRUE(sim.plans()[0].integrator.empty());
  const std::int64_t evaluations = sim.evaluations();
  while (sim.steps() < 200) sim.step();
  EXPECT_EQ(sim.evaluations(), evaluations);
}

// What was in the spring is gone at once, and the balance knows it.
TEST(BreakingSpring, TakesItsEnergyOutOfTheBalance) {
  for (const char* name : {"dop853", "auto"}) {
    Simulation sim = tetheredBall().simulation(name, 0.01);
    sim.trackBalance();
    while (sim.steps() < 100) sim.step();
    const double stored = kLimit * kLimit / kStiffness / 2;
    EXPECT_NEAR(sim.exchanged().energy, -stored, 1e-12) << name;
    // of auto: its tolerance
    EXPECT_NEAR(sim.balance().energy, 0, std::string(name) == "auto" ? 1e-9 : 1e-12) << name;
  }
}

// The tension passes the limit and is back below it within one step.
TEST(BreakingSpring, BreaksWhereItsTensionExceedsTheLimitWithinAStep) {
  Bench bench;
  bench.add(principalBody("ball", kMass, {0.1, 0.1, 0.1}), tumbling({kSpeed, 0, 0}, {0, 0, 0}));
  const double most = kStiffness * kSpeed / std::sqrt(kStiffness / kMass);
  bench.world.laws.push_back(std::make_shared<BreakingSpring>(Spring::End{kWorld, Vector3d::Zero()},
                                                              Spring::End{0, Vector3d::Zero()},
                                                              kStiffness, 0.99 * most));
  // a quarter of the period is 0.314 s: the peak lies in the middle of the second step
  EXPECT_EQ(bench.run("dop853", 0.42, 2).laws, std::vector<double>{0});
}

TEST(BreakingSpring, PartsThePairThatItHeld) {
  Bench bench;
  for (double x : {0.0, 1.0}) {
    BodyFrameMotion motion = tumbling({x > 0 ? 4.0 : -4.0, 0, 0}, {0, 0, 0});
    motion.x_W.x() = x;
    bench.add(principalBody(x > 0 ? "right" : "left", 1, {0.1, 0.1, 0.1}), motion);
  }
  bench.world.laws.push_back(std::make_shared<BreakingSpring>(
      Spring::End{0, Vector3d::Zero()}, Spring::End{1, Vector3d::Zero()}, 40, 50));
  Simulation sim = bench.simulation("auto", 0.01);
  EXPECT_EQ(sim.plans().size(), 1u);
  while (sim.steps() < 100) sim.step();
  EXPECT_EQ(sim.plans().size(), 2u);
  EXPECT_EQ((sim.body(0).p_W + sim.body(1).p_W).norm(), 0);
}

// A run that is taken up from a state, before and after the event, has the bits of the whole.
TEST(BreakingSpring, GoesOnFromAStateWithTheSameBits) {
  for (const char* name : {"dop853", "auto", "strang"})
    test::expectToGoOnTheSame(tetheredBall().simulation(name, 0.01), {3, 12, 40});
}

// A string that is slack does not act: its bodies are solved, up to the instant at which it is
// taut.
TEST(String, TautensAtItsInstantWhateverTheStep) {
  constexpr double kLength = 0.5, g = 10;
  for (double step : {0.001, 0.03, 0.2}) {
    Bench bench;
    bench.world.g_W = {0, 0, -g};
    bench.add(principalBody("ball", 1, {0.1, 0.1, 0.1}), BodyFrameMotion());
    bench.world.laws.push_back(std::make_shared<test::String>(
        Spring::End{kWorld, Vector3d::Zero()}, Spring::End{0, Vector3d::Zero()}, 200, kLength));
    Simulation sim = bench.simulation("auto", step);
    EXPECT_TRUE(sim.plans()[0].integrator.empty());
    while (sim.time() < 0.6 - 1e-9) sim.step();
    // falls for √(2 l/g), then z + l swings about −g/ω² with ω² = k/m
    const double w = std::sqrt(200.0), t = sim.time() - std::sqrt(2 * kLength / g);
    const double v = -std::sqrt(2 * g * kLength), sag = g / (w * w);
    const double half = (M_PI + 2 * std::atan(-sag * w / v)) / w;  // until it is slack again
    const double expected = t < half
                                ? -kLength - sag + sag * std::cos(w * t) + v / w * std::sin(w * t)
                                : -kLength - v * (t - half) - g / 2 * (t - half) * (t - half);
    EXPECT_NEAR(sim.body(0).x_W.z(), expected, 1e-9) << step;
  }
}

// A spring and a dashpot in series: the dashpot's length is a state of the law.
TEST(MaxwellElement, ConvergesAtTheOrderOfEveryIntegratorThatSupportsIt) {
  const double expected = test::maxwellPosition(1);
  for (const std::string& name : supporting(kCoupling | kLawStates)) {
    std::vector<double> errors;
    for (int steps : {50, 100})
      errors.push_back(
          std::abs(test::maxwellBench().run(name, 1, steps).bodies[0].x_W.x() - expected));
    if (name == "auto") {
      EXPECT_LT(errors[0], 1e-9) << name;
    } else if (errors[1] > 1e-12) {
      EXPECT_GT(errors[0] / errors[1], std::exp2(methodNamed(name).order) / 1.5) << name;
    }
  }
}

TEST(MaxwellElement, DissipatesWhatTheBalanceSays) {
  Simulation sim = test::maxwellBench().simulation("dop853", 0.01);
  sim.trackBalance();
  while (sim.steps() < 100) sim.step();
  EXPECT_LT(sim.exchanged().energy, -0.1);
  EXPECT_NEAR(sim.balance().energy, 0, 1e-12);
}

TEST(MaxwellElement, IsRefusedWhereItsStatesWouldLoseTheOrder) {
  EXPECT_THROW(test::maxwellBench().simulation("kahan_li8", 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace rigid_body_sim
