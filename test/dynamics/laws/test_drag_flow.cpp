#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/dynamics/drag.hpp>

#include "dynamics/laws/drag_flow.hpp"
#include "support/random_bodies.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kUnit = 2.22e-16;  // of rounding

TEST(DragFlow, HasTheShareThatDecayLeavesToRounding) {
  EXPECT_EQ(smallDecayShare(0.0), 1);
  for (int i = -1000; i <= 1000; ++i) {
    if (i == 0) continue;
    const double x = i / 1000.0, share = -std::expm1(-x) / x;
    EXPECT_NEAR(smallDecayShare(x), share, 4 * kUnit * share) << x;
    // the next term of the slope is x⁶/5760, over 1 + the rest of its series
    const double slope = (std::exp(-x) * (1 + x) - 1) / (x * x);
    EXPECT_NEAR(decayShareSlope(x), slope, 3e-4) << x;
  }
}

/// The root of ½ (|p|/m + |after(v)|/m) = v by bisection.
double meanSpeed(const DragNumbers<double>& drag, double m, const Vector3d& p, const Vector3d& f,
                 double h) {
  const auto after = [&](double v) -> Vector3d {
    const double x = (drag.linear + drag.quadratic * v) / m * h;
    const double share = x == 0 ? 1 : -std::expm1(-x) / x;
    return std::exp(-x) * p + h * share * f;
  };
  double low = 0, high = (p.norm() + h * f.norm()) / m;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * (p.norm() + after(middle).norm()) / m > middle ? low : high) = middle;
  }
  return high;
}

TEST(DragFlow, SlowsByTheMeanSpeedToRounding) {
  Draw draw(3);
  for (int i = 0; i < 500; ++i) {
    const double m = draw.uniform(0.1, 10), h = draw.uniform(1e-4, 0.1);
    const Vector3d p = i % 7 == 0 ? Vector3d(Vector3d::Zero()) : draw.vector(m);
    const Vector3d f = i % 5 == 0 ? Vector3d(-p / h) : draw.vector(m / h);
    const double fastest = (p.norm() + h * f.norm()) / m;
    // the two take up to all that the series allows
    const double share = draw.uniform(0, 1) * m / h;
    const double part = draw.uniform(0, 1);
    const DragNumbers<double> drag{part * share, (1 - part) * share / (fastest + 1e-300), 0};
    const double x = (drag.linear + drag.quadratic * meanSpeed(drag, m, p, f, h)) / m * h;
    const Vector3d expected = std::exp(-x) * p + h * (x == 0 ? 1 : -std::expm1(-x) / x) * f;
    const Triple<double> after =
        relaxedMomentum<double>(drag, m, {p.x(), p.y(), p.z()}, {f.x(), f.y(), f.z()}, h);
    const Vector3d difference = Vector3d(after.x, after.y, after.z) - expected;
    // some ten roundings of what is added up
    EXPECT_LE(difference.norm(), 16 * kUnit * (p.norm() + h * f.norm())) << i;
  }
}

TEST(DragFlow, OfMoreThanTheMomentumSlowsByTheMeanSpeed) {
  Draw draw(4);
  Body body;
  for (int i = 0; i < 500; ++i) {
    const double m = body.mass = draw.uniform(0.1, 10), h = draw.uniform(1e-4, 0.1);
    const Vector3d p = i % 7 == 0 ? Vector3d(Vector3d::Zero()) : draw.vector(m);
    const Vector3d f = i % 5 == 0 ? Vector3d(Vector3d::Zero()) : draw.vector(m / h);
    const double fastest = (p.norm() + h * f.norm()) / m;
    const double share = draw.uniform(1, 40) * m / h;
    const double part = i % 3 == 0 ? 1 : draw.uniform(0, 1);
    const DragNumbers<double> drag{part * share, (1 - part) * share / (fastest + 1e-300), 0};
    const double x = (drag.linear + drag.quadratic * meanSpeed(drag, m, p, f, h)) / m * h;
    const Vector3d expected = std::exp(-x) * p + h * (x == 0 ? 1 : -std::expm1(-x) / x) * f;
    BodyState state;
    state.p_W = p;
    Wrench wrench;
    wrench.f_W = f;
    Drag(0, {drag.linear, drag.quadratic, 0}).kick(body, wrench, h, state);
    // as above
    EXPECT_LE((state.p_W - expected).norm(), 16 * kUnit * (p.norm() + h * f.norm())) << i;
  }
}

}  // namespace
}  // namespace rigid_body_sim
