#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/buoyancy.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>

#include "dynamics/medium/medium_segment.hpp"
#include "support/random_bodies.hpp"
#include "support/refusal.hpp"
#include "support/worlds.hpp"

/// Media at the limits: two laws of one kind, numbers near overflow, components that are rounding.
namespace rigid_body_sim {
namespace {

test::Bench bodyInMedium(std::vector<std::shared_ptr<const ForceLaw>> laws) {
  test::Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(test::principalBody("ball", 2, {0.1, 0.15, 0.2}),
            test::tumbling({1, 2, 3}, {1, 0.5, -1}));
  bench.world.laws = std::move(laws);
  return bench;
}

std::shared_ptr<const ForceLaw> mediumDrag(
    const std::function<void(MediumDrag::Coefficients&)>& f) {
  MediumDrag::Coefficients drag;
  f(drag);
  return std::make_shared<MediumDrag>(0, drag, Vector3d(0, 1, 0));
}

std::shared_ptr<const ForceLaw> buoyancyOf(double displaced) {
  return std::make_shared<Buoyancy>(0, displaced, Vector3d(0.1, 0, 0.3), Vector3d(0, 0, -9.81));
}

std::string mediumRefusal(const test::Bench& bench) {
  return test::refusalOf([&] { bench.simulation("auto", 0.01); });
}

bool isFinite(const BodyState& s) {
  return s.x_W.allFinite() && s.q_WP.coeffs().allFinite() && s.p_W.allFinite() &&
         s.L_W.allFinite() && s.L_P.allFinite();
}

}  // namespace

// The solution takes one of each kind, integrators would take their sum.
TEST(MediumLaws, AreRefusedTwiceOnOneBody) {
  const auto drag = mediumDrag([](auto& d) { d.linear.alike = 1; });
  const auto plain = std::make_shared<Drag>(0, Drag::Coefficients{1, 0, 0});
  const auto lift = buoyancyOf(1);
  EXPECT_EQ(mediumRefusal(bodyInMedium({drag, lift})), "");
  EXPECT_EQ(mediumRefusal(bodyInMedium({drag, plain})), "law 'drag': body 'ball' has one already");
  EXPECT_EQ(mediumRefusal(bodyInMedium({drag, lift, drag})),
            "law 'drag': body 'ball' has one already");
  EXPECT_EQ(mediumRefusal(bodyInMedium({lift, drag, lift})),
            "law 'buoyancy': body 'ball' has one already");
}

// Nothing turns the body, so that its solution has no end; its position overflows within 1e5 s. A
// run that goes on from a state begins at the anchor, where all numbers of the body are small.
TEST(MediumLaws, StopTheRunBeforeAStateIsNotFinite) {
  const auto lift = std::make_shared<Buoyancy>(0, 1e299, Vector3d::Zero(), Vector3d(0, 0, -9.81));
  test::Bench bench = bodyInMedium({lift});
  bench.initial.bodies[0].L_W.setZero();
  bench.initial.bodies[0].L_P.setZero();
  Simulation first = bench.simulation("auto", 1e3), sim = first;
  first.step();
  ASSERT_TRUE(isFinite(first.body(0)));
  sim.load(first.state());
  bool has_stopped = false;
  while (!has_stopped && sim.steps() < 100) {
    try {
      sim.step();
    } catch (const SimulationDiverged&) {
      has_stopped = true;
    }
    ASSERT_TRUE(isFinite(sim.body(0))) << sim.time();
  }
  EXPECT_TRUE(has_stopped);
}

// Wind along an axis of the drag: the components along the others are rounding of either sign,
// while the body slowly gains speed along one of them.
TEST(MediumSegment, IsNotCutShortByTheSignOfARounding) {
  constexpr double kSpeed = 5;
  for (unsigned seed = 0; seed < 12; ++seed) {
    Draw draw(seed);
    MediumLoad load;
    load.quadratic_axes = {1, 1, 1};
    load.R_PD = draw.attitude().toRotationMatrix();
    const Body body = test::principalBody("ball", 2, {1, 1, 1});
    HeldWrench wrench;
    wrench.medium = &load;
    for (double gain : {1e-8, -1e-8, 1e-12, -1e-12}) {
      for (double start : {0.0, 0.9e-12, -0.9e-12}) {
        const Vector3d across = load.R_PD.col(1);
        BodyState state;
        state.p_W = body.mass * kSpeed * (load.R_PD.col(0) + start * across);
        const MediumSegment segment(body, wrench, Vector3d(gain * kSpeed * across), state);
        EXPECT_GT(segment.validFor(), 1e-3) << seed << " " << gain << " " << start;
      }
    }
  }
}

/// Drag as strong as numbers allow, up to speeds without a square: v = v0/(1 + k v0 t), and the way
/// ln(1 + k v0 t)/k, with k = c/m.
TEST(MediumLaws, SlowABodyDownByQuadraticDragOfAnyStrength) {
  constexpr double kSpeed = 1, kMass = 2;
  for (const double c : {1e20, 1e120, 1e160, 1e200, 1e240, 1e300}) {
    Drag::Coefficients alike;
    alike.quadratic = c;
    MediumDrag::Coefficients along;
    along.quadratic.axes = {c, c, c};
    const std::vector<std::shared_ptr<const ForceLaw>> laws{
        std::make_shared<Drag>(0, alike), std::make_shared<MediumDrag>(0, along, Vector3d::Zero())};
    for (const auto& drag : laws) {
      test::Bench bench;
      bench.add(test::principalBody("ball", kMass, {0.1, 0.15, 0.2}),
                test::tumbling({kSpeed, 0, 0}, {0, 0, 0}));
      bench.world.laws = {drag};
      Simulation sim = bench.simulation("auto", 0.01);
      sim.step(100);
      const double gone = c / kMass * kSpeed * sim.time(), way = std::log1p(gone) * kMass / c;
      const double speed = kSpeed / (1 + gone);
      constexpr double kAtRest = 1e-250;  // [m/s] below that a body is at rest
      EXPECT_NEAR(sim.body(0).x_W.x(), way, 1e-12 * way + kAtRest * sim.time()) << c;
      EXPECT_NEAR(sim.body(0).p_W.x() / kMass, speed, 1e-12 * speed + kAtRest) << c;
    }
  }
}

}  // namespace rigid_body_sim
