#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/law_benches.hpp"

/// Springs with a rest length whose ends come as near as they may: there the force turns about, in
/// no time where the ends meet.
namespace rigid_body_sim {
namespace {

using namespace test;

constexpr double kPassingStiffness = 100, kPassingRestLength = 1;
constexpr double kPassingTime = 10;
constexpr double kPassingPath = 60;  // [m] that the ball flies at least

/// A ball of 1 kg on a spring to the world's origin, aimed past it at a distance.
Bench aimedPast(double distance, double speed) {
  Bench bench;
  BodyFrameMotion motion = tumbling({-speed, 0, 0}, {0, 0, 0});
  motion.x_W = {2, distance, 0};
  bench.add(principalBody("ball", 1, {1, 1, 1}), motion);
  bench.addSpring({kWorld, {0, 0, 0}}, {0, {0, 0, 0}}, {kPassingStiffness, 0, kPassingRestLength});
  bench.world.solver.horizon = kPassingTime;
  return bench;
}

/// The ball's place at time t if it is aimed at the origin itself: it swings about +1 rest length
/// until it comes to the origin, about −1 rest length until it is back there, and so on.
double placeOfPassing(double t, double speed) {
  const double w = std::sqrt(kPassingStiffness),
               amplitude = std::hypot(2 - kPassingRestLength, speed / w);
  const double phase = std::asin(kPassingRestLength / amplitude);
  const double swing = (M_PI + 2 * phase) / w;                         // from the origin and back
  const double start = (M_PI / 2 + std::atan(speed / w) + phase) / w;  // since it left the origin
  const double swings = std::floor((start + t) / swing);
  const double place =
      kPassingRestLength + amplitude * std::sin(w * (start + t - swings * swing) - phase);
  return std::fmod(swings, 2) == 0 ? place : -place;
}

/// The same in the plane, by the classical Runge-Kutta method at steps that follow the distance.
struct PlaneMotion {
  double x, y, vx, vy;
};

PlaneMotion planeRate(const PlaneMotion& s) {
  const double r = std::hypot(s.x, s.y), pull = -kPassingStiffness * (r - kPassingRestLength) / r;
  return {s.vx, s.vy, pull * s.x, pull * s.y};
}

PlaneMotion planeMoved(const PlaneMotion& s, const PlaneMotion& d, double h) {
  return {s.x + h * d.x, s.y + h * d.y, s.vx + h * d.vx, s.vy + h * d.vy};
}

PlaneMotion planeReference(PlaneMotion s, double duration) {
  for (double left = duration; left > 0;) {
    const double far = std::hypot(s.x, s.y) / std::hypot(s.vx, s.vy);
    const double h = std::min({left, 2e-4, 0.01 * far});
    const PlaneMotion a = planeRate(s), b = planeRate(planeMoved(s, a, h / 2)),
                      c = planeRate(planeMoved(s, b, h / 2)), d = planeRate(planeMoved(s, c, h));
    s = planeMoved(planeMoved(planeMoved(planeMoved(s, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
    left -= h;
  }
  return s;
}

TEST(SpringPassage, ThroughTheOtherEndHoldsTheTolerance) {
  for (double speed : {0.3, 1.0, 7.0})
    for (double step : {0.01, 0.05, 0.2}) {
      Simulation sim = aimedPast(0, speed).simulation("auto", step);
      while (sim.time() < kPassingTime - 1e-9) sim.step();
      EXPECT_NEAR(sim.body(0).x_W.x(), placeOfPassing(sim.time(), speed), 1e-9 * kPassingPath)
          << speed << ' ' << step;
      EXPECT_EQ(sim.body(0).x_W.y(), 0);
    }
}

TEST(SpringPassage, CloseToTheOtherEndHoldsTheTolerance) {
  for (double distance : {1e-2, 1e-4, 1e-6, 1e-9}) {
    const PlaneMotion truth = planeReference({2, distance, -1, 0}, kPassingTime);
    for (double step : {0.01, 0.05, 0.2}) {
      Simulation sim = aimedPast(distance, 1).simulation("auto", step);
      while (sim.time() < kPassingTime - 1e-9) sim.step();
      EXPECT_NEAR(sim.body(0).x_W.x(), truth.x, 1e-9 * kPassingPath) << distance << ' ' << step;
      EXPECT_NEAR(sim.body(0).x_W.y(), truth.y, 1e-9 * kPassingPath) << distance << ' ' << step;
    }
  }
}

// Two bodies of twice the mass move towards one another as the ball towards the origin.
TEST(SpringPassage, OfTwoBodiesHoldsTheTolerance) {
  Bench bench;
  bench.add(principalBody("left", 2, {1, 1, 1}), tumbling({0.5, 0, 0}, {0, 0, 0}));
  BodyFrameMotion motion = tumbling({-0.5, 0, 0}, {0, 0, 0});
  motion.x_W = {2, 0, 0};
  bench.add(principalBody("right", 2, {1, 1, 1}), motion);
  bench.addSpring({0, {0, 0, 0}}, {1, {0, 0, 0}}, {kPassingStiffness, 0, kPassingRestLength});
  bench.world.solver.horizon = kPassingTime;
  const State end = bench.run("auto", kPassingTime, 1000);
  EXPECT_NEAR(end.bodies[1].x_W.x() - end.bodies[0].x_W.x(), placeOfPassing(kPassingTime, 1),
              1e-9 * kPassingPath);
}

}  // namespace
}  // namespace rigid_body_sim
