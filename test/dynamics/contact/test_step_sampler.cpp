#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/step_sampler.hpp>

#include "support/contact_benches.hpp"

/// Many states within a long step in contact.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

constexpr double kLongStep = 1;  // [s]

/// A ball that rolls, and one that bounces beside it.
Simulation rollsAndBounces() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  const ContactParameters c = contactOf(1e6, 1.5, 0.3, 0.5);
  const double depth = std::pow(9.81 / c.stiffness, 1 / c.exponent);
  test::addBall(bench, 0.1, 1, motionAt({0, 0, 0.1 - depth}, {1, 0, 0}, {0, 10, 0}), HalfSpace{},
                c);
  test::addBall(bench, 0.1, 1, motionAt({0, 1, 0.15}, {0, 0, 0}, {3, 0, 0}), HalfSpace{}, c);
  bench.initial.contact_bound = 1e-11;
  return bench.simulation("auto", kLongStep);
}

TEST(StepSampler, GivesManyStatesAtTheCostOfTheStep) {
  constexpr int kSamples = 200;
  Simulation sim = rollsAndBounces();
  StepSampler sampler(sim);
  for (int k = 1; k <= kSamples; ++k) {
    const double t = kLongStep * k / kSamples;
    const State sampled = sampler.at(t);
    EXPECT_EQ(sampled.t, t);
    if (k % 40 != 0) continue;
    const State alone = sim.sample(t);
    for (std::size_t i = 0; i < 2; ++i) {
      const BodyState &a = sampled.bodies[i], &b = alone.bodies[i];
      EXPECT_NEAR(((a.x_W - b.x_W) + (a.x_low_W - b.x_low_W)).norm(), 0, 1e-9) << t;
      EXPECT_NEAR(angleBetween(a.q_WP, b.q_WP), 0, 1e-8) << t;
    }
  }
  const std::int64_t of_samples = sampler.evaluations();
  sim.step();
  EXPECT_LT(of_samples, 3 * sim.evaluations());  // each from the start: 100 times it
}

TEST(StepSampler, RefusesTimesThatAreBehindItOrBeyondTheStep) {
  StepSampler sampler(rollsAndBounces());
  sampler.at(0.5);
  EXPECT_THROW(sampler.at(0.4), std::invalid_argument);
  EXPECT_THROW(sampler.at(1.1), std::invalid_argument);
  EXPECT_THROW(sampler.at(std::nan("")), std::invalid_argument);
  EXPECT_EQ(sampler.at(1).t, 1);
}

}  // namespace
}  // namespace rigid_body_sim
