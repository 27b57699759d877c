#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "dynamics/contact/normal_law.hpp"
#include "dynamics/methods/dop853_coefficients.hpp"
#include "support/costed_contacts.hpp"

/// What contact costs, counted in evaluations, which are the same on every machine.
namespace rigid_body_sim {
namespace {

std::pair<State, std::int64_t> runCosted(test::CostedContact c, double bound) {
  c.bench.initial.contact_bound = bound;
  Simulation sim = c.bench.simulation("auto", c.duration);
  sim.step();
  return {sim.state(), sim.evaluations()};
}

bool isNearer(const State& end, const State& truth, double metre, double radian) {
  for (std::size_t i = 0; i < truth.bodies.size(); ++i)
    if (!(distanceBetween(end.bodies[i], truth.bodies[i]) <= metre &&
          angleBetween(end.bodies[i].q_WP, truth.bodies[i].q_WP) <= radian))
      return false;
  return true;
}

// Evaluations stay within what was stated where a step may err by 1e-9. Errors do, too, there or
// at a tenth of it for no more evaluations.
TEST(ContactCost, IsWithinWhatWasStated) {
  for (const test::CostedContact& c : test::costedContacts()) {
    const State truth = runCosted(c, 1e-14).first;
    auto [end, evaluations] = runCosted(c, 1e-9);
    EXPECT_LE(evaluations, c.evaluations) << c.name;
    if (!isNearer(end, truth, c.metre, c.radian)) std::tie(end, evaluations) = runCosted(c, 1e-10);
    EXPECT_LE(evaluations, c.evaluations) << c.name;
    EXPECT_TRUE(isNearer(end, truth, c.metre, c.radian)) << c.name;
  }
}

// A bristle of the breakaway that scenes have by default swings at ω² = 7/2 μ g/b under a ball that
// rolls. Explicit steps cannot be longer than is stable: 6.7/ω at its damping, 23 500 evaluations
// in ten seconds. So 21 000 were stated of a softer one.
TEST(ContactCost, OfRollingIsWhatStabilityAsksFor) {
  const test::CostedContact c = test::stifferRolling();
  const double swing = std::sqrt(3.5 * 0.5 * Bristles::kEarthGravity / 1e-5);
  EXPECT_LT(runCosted(c, 1e-9).second, 1.1 * 12 * c.duration * swing / 5);
}

// Estimates of momenta are rounding where a box lies at the tightest bound: steps that became ever
// shorter would make them no less. Measured: 152 000 evaluations, most of them until it lies.
TEST(ContactCost, OfABoxThatLiesIsNotRaisedByRounding) {
  test::Bench bench = test::underGravity();
  BodyFrameMotion motion = test::motionAt({0, 0, 0.3}, {1, 0.2, 0}, {1, 2, 0.5});
  motion.q_WB = rotationExp(Vector3d(0.3, 0.5, 0.2));
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, motion, HalfSpace{}, test::contactOf(1e8, 1.5, 0.3, 0.5));
  bench.initial.contact_bound = 1e-16;
  bench.world.solver.tolerance = 1e-13;
  Simulation sim = bench.simulation("auto", 0.002);
  while (sim.time() < 2) sim.step();
  EXPECT_LT(sim.evaluations(), 250000);
}

/// By how much a step of dop853 multiplies y where y' = λ y, with z = λ h.
double amplification(std::complex<double> z) {
  std::array<std::complex<double>, dop853::kStages> rates;
  std::complex<double> end = 1;
  for (std::size_t i = 0; i < dop853::kStages; ++i) {
    std::complex<double> stage = 1;
    for (std::size_t j = 0; j < i; ++j) stage += z * dop853::kA[i][j] * rates[j];
    rates[i] = stage;
    end += z * dop853::kB[i] * rates[i];
  }
  return std::abs(end);
}

// Steps in contact may turn or decay by 5 rad: swings, and what is damped however much, die out.
TEST(StabilityOfDop853, ReachesBeyondTheLongestStepInContact) {
  constexpr double kBeyond = 5.9;
  for (double turn = 0.1; turn < kBeyond; turn += 0.1)
    for (double damping = 0; damping <= 1; damping += 0.05) {
      const std::complex<double> direction(-damping, std::sqrt(1 - damping * damping));
      EXPECT_LT(amplification(turn * direction), 1) << turn << ' ' << damping;
    }
  EXPECT_GT(amplification(-6.5), 1);
}

}  // namespace
}  // namespace rigid_body_sim
