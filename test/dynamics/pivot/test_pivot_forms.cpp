#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "support/worlds.hpp"

/// Bodies on a pivot whose motion is known in closed form.
namespace rigid_body_sim {
namespace {

constexpr double kG = 9.81;

using test::Bench;

Bench onPivot(const Body& body, const BodyFrameMotion& motion, double g = kG) {
  test::Bench bench;
  bench.world.g_W = {0, 0, -g};
  bench.add(body, motion);
  return bench;
}

BodyFrameMotion tilted(double angle, const Vector3d& w_B) {
  return test::tumbling({0, 0, 0}, w_B, Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitX())));
}

/// A pendulum about the x axis, its centre of mass 0.4 m below the pivot: I = 1.2 + 3 · 0.16.
Bench pendulum(double angle) {
  const Body body = makeBody("bob", {3, {0.1, 0.2, -0.1}, Vector3d(1.2, 0.9, 0.7).asDiagonal()}, {},
                             Vector3d(0.1, 0.2, 0.3));
  return onPivot(body, tilted(angle, {0, 0, 0}));
}
constexpr double kPendulumInertia = 1.68, kPendulumMoment = 3 * kG * 0.4;

/// Its angle [rad] about the x axis.
double angleOf(const Simulation& sim) {
  const Quaterniond q = toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB;
  return 2 * std::atan2(q.x(), q.w());
}

struct Top {
  double I_t = 0.044, I_3 = 0.006, w_3 = 120, angle = 0.5;

  Bench bench(const Vector3d& w_B) const {
    const Body body = makeBody("top", {1, {0, 0, 0.2}, Vector3d(0.004, 0.004, 0.006).asDiagonal()},
                               {}, Vector3d::Zero());
    return onPivot(body, tilted(angle, w_B));
  }
};

using Wide = long double;

/// cos of the angle between the axis of the top and the vertical.
Wide heightOf(const Simulation& sim) {
  const Quaterniond of_B = toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB;
  const Quaternion<Wide> q = of_B.cast<Wide>().normalized();
  return 1 - 2 * (q.x() * q.x() + q.y() * q.y());
}

/// sn(u, k) by the arithmetic-geometric mean (Abramowitz and Stegun, 16.4).
Wide ellipticSine(Wide u, Wide k) {
  constexpr int kDepth = 8;
  std::array<Wide, kDepth + 1> a{1}, c{k};
  Wide b = std::sqrt(1 - k * k);
  for (std::size_t i = 1; i <= kDepth; ++i) {
    a[i] = (a[i - 1] + b) / 2;
    c[i] = (a[i - 1] - b) / 2;
    b = std::sqrt(a[i - 1] * b);
  }
  Wide phi = std::ldexp(a[kDepth] * u, kDepth);
  for (std::size_t i = kDepth; i > 0; --i) phi = (phi + std::asin(c[i] / a[i] * std::sin(phi))) / 2;
  return std::sin(phi);
}

Quaternion<Wide> turned(Wide angle, const Vector3<Wide>& axis) {
  return Quaternion<Wide>(Eigen::AngleAxis<Wide>(angle, axis));
}

/// Asks for the angle and the rate once more after so many periods.
void expectToComeBackAfter(int periods, double angle) {
  const double period =
      4 * std::sqrt(kPendulumInertia / kPendulumMoment) * std::comp_ellint_1(std::sin(angle / 2));
  Simulation sim = pendulum(angle).simulation("auto", period * periods / 100);
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_NEAR(angleOf(sim), angle, 1e-13 * periods) << angle;
  EXPECT_LT(sim.body(0).L_P.norm(), 1e-13 * periods * kPendulumMoment) << angle;
}

}  // namespace

// Within rounding of some radians a period.
TEST(Pendulum, ComesBackAfterItsPeriod) {
  for (double angle : {0.01, 0.5, 2.0, 3.0}) expectToComeBackAfter(1, angle);
  // few: swings in a plane are unstable if wide
  expectToComeBackAfter(5, 0.5);
}

// sin ½θ = k sin φ, F(φ, k) = K − t √(m g c/I), in the first quarter of a period.
TEST(Pendulum, SwingsByAnEllipticFunction) {
  const double k = std::sin(1.0), rate = std::sqrt(kPendulumMoment / kPendulumInertia);
  Simulation sim = pendulum(2.0).simulation("auto", 0.01);
  for (int i = 0; i < 60; ++i) {
    sim.step();
    const double phi = std::asin(std::sin(angleOf(sim) / 2) / k);
    if (phi > 1.4) continue;  // time from a place where it hardly moves has few digits
    ASSERT_GT(phi, -1.4);
    EXPECT_NEAR(std::ellint_1(k, phi), std::comp_ellint_1(k) - rate * sim.time(), 1e-13);
  }
}

// R = exp(Ω t ẑ) R₀ exp((ω₃ − Ω cos θ) t e₃) for either root of I_t cos θ Ω² − I₃ ω₃ Ω + m g c = 0.
// The state at the start holds the rates to 2⁻⁵³ of their size: 1000 rad of turning later that is
// 1e-13 rad, of each of the two.
TEST(HeavyTop, PrecessesSteadily) {
  const Top top;
  const Wide a = Wide(top.I_t) * std::cos(Wide(top.angle)), b = Wide(top.I_3) * Wide(top.w_3);
  const Wide mgc = Wide(kG) * Wide(0.2);
  for (int sign : {-1, 1}) {
    const Wide root = std::sqrt(b * b - 4 * a * mgc);
    const Wide rate = sign < 0 ? 2 * mgc / (b + root) : (b + root) / (2 * a);
    const Wide spin = Wide(top.w_3) - rate * std::cos(Wide(top.angle));
    const Vector3<Wide> up_B(0, std::sin(Wide(top.angle)), std::cos(Wide(top.angle)));
    const Vector3<Wide> w_B = rate * up_B + spin * Vector3<Wide>::UnitZ();
    Simulation sim = top.bench(w_B.cast<double>()).simulation("auto", 0.01);
    while (sim.steps() < 1000) {
      sim.step();
      const Wide t = sim.time();
      const Quaternion<Wide> expected = turned(rate * t, Vector3<Wide>::UnitZ()) *
                                        turned(top.angle, Vector3<Wide>::UnitX()) *
                                        turned(spin * t, Vector3<Wide>::UnitZ());
      const Quaterniond q = toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB;
      const Wide error = (q.cast<Wide>().normalized().conjugate() * expected).vec().norm() * 2;
      EXPECT_LT(error, 1e-13L * std::max<Wide>(1, (rate + top.w_3) * t / 100)) << sign << t;
    }
  }
}

// cos θ = u₁ + (u₀ − u₁) sn²(n t + K), over ten nutations. In double the reference itself would
// err by 1e-13: it divides by u₀ − u₁ = 0.16 and by the derivative of sn.
TEST(HeavyTop, NodsByAnEllipticFunction) {
  const Top top;
  const Bench bench = top.bench({0, 0, top.w_3});
  const Body& body = bench.world.bodies[0];
  const Wide u_0 = heightOf(bench.simulation("auto", 0.005));
  const Wide b = 2 * Wide(kG) * Wide(0.2) / Wide(body.I[1]);
  const Wide a = Wide(bench.initial.bodies[0].L_P[0]) / Wide(body.I[1]);
  // (1 − u²) b = a² (u₀ − u)
  const Wide p = a * a / b, q = a * a * u_0 / b - 1, root = std::sqrt(p * p / 4 - q);
  const Wide u_3 = p / 2 + root, u_1 = q / u_3;
  const Wide k = std::sqrt((u_0 - u_1) / (u_3 - u_1)), n = std::sqrt(b * (u_3 - u_1)) / 2;
  const Wide quarter = std::comp_ellint_1(k);
  Simulation sim = bench.simulation("auto", 0.005);
  double lowest = 1;
  while (n * Wide(sim.time()) < 20 * quarter) {
    sim.step();
    const Wide sn = ellipticSine(n * Wide(sim.time()) + quarter, k);
    const Wide height = heightOf(sim);
    EXPECT_NEAR(static_cast<double>(height - (u_1 + (u_0 - u_1) * sn * sn)), 0, 1e-13)
        << sim.time();
    lowest = std::min(lowest, static_cast<double>(height));
  }
  EXPECT_LT(lowest, u_1 + 1e-3L);
}

// Three equal moments about a pivot on an axis of symmetry are as good as none: the rotation about
// the centre of mass is exact whatever gravity is.
TEST(AirBearingTable, TurnsFreelyUnderGravity) {
  const Body body = makeBody("table", {5, {0.1, -0.2, 0.3}, Vector3d(1, 2, 2.5).asDiagonal()}, {},
                             Vector3d(0.1, -0.2, 0.3));
  const Bench bench = onPivot(body, test::tumbling({0, 0, 0}, {0.5, 2, -0.3}));
  const Bench free =
      onPivot(makeBody("table", {5, {0.1, -0.2, 0.3}, Vector3d(1, 2, 2.5).asDiagonal()}),
              test::tumbling({0, 0, 0}, {0.5, 2, -0.3}), 0);
  const State end = bench.run("auto", 10, 100), truth = free.run("auto", 10, 100);
  EXPECT_EQ(end.bodies[0].q_WP.coeffs(), truth.bodies[0].q_WP.coeffs());
  EXPECT_EQ(end.bodies[0].L_W, bench.initial.bodies[0].L_W);
  EXPECT_EQ(describeSolution(bench.simulation("auto", 0.1))[0],
            "table: gravity, pivot, asymmetric, exact");
}

TEST(HeavyTop, IsSolvedBySeries) {
  EXPECT_EQ(describeSolution(Top().bench({0, 0, 120}).simulation("auto", 0.1))[0],
            "top: gravity, pivot, Taylor");
}

// No torque about the vertical, and none about the axis of symmetry.
TEST(HeavyTop, KeepsEnergyAndTwoAngularMomenta) {
  const Bench bench = Top().bench({3, -2, 120});
  Simulation sim = bench.simulation("auto", 0.01);
  const Totals start = totalsOf(sim.world(), sim.state());
  const BodyState first = sim.body(0);
  for (int i = 0; i < 10000; ++i) sim.step();
  const double scale = first.L_W.norm();
  EXPECT_NEAR(totalsOf(sim.world(), sim.state()).energy, start.energy, 1e-12 * start.energy);
  EXPECT_NEAR(sim.body(0).L_W.z(), first.L_W.z(), 1e-13 * scale);
  EXPECT_NEAR(sim.body(0).L_P(0), first.L_P(0), 1e-12 * scale);
}

}  // namespace rigid_body_sim
