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
  double I_t = 0.044, I_3 = 0.006, mgc = kG * 0.2, w_3 = 120, angle = 0.5;

  Bench bench(const Vector3d& w_B) const {
    const Body body = makeBody("top", {1, {0, 0, 0.2}, Vector3d(0.004, 0.004, 0.006).asDiagonal()},
                               {}, Vector3d::Zero());
    return onPivot(body, tilted(angle, w_B));
  }
};

/// cos of the angle between the axis of the top and the vertical.
double heightOf(const Simulation& sim) {
  const Quaterniond q = toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB;
  return rotate(q, Vector3d(Vector3d::UnitZ())).z();
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
// Rounding: 1000 rad of turning.
TEST(HeavyTop, PrecessesSteadily) {
  const Top top;
  const double a = top.I_t * std::cos(top.angle), b = top.I_3 * top.w_3;
  for (double sign : {-1.0, 1.0}) {
    const double root = std::sqrt(b * b - 4 * a * top.mgc);
    const double rate = sign < 0 ? 2 * top.mgc / (b + root) : (b + root) / (2 * a);
    const double spin = top.w_3 - rate * std::cos(top.angle);
    const Vector3d up_B(0, std::sin(top.angle), std::cos(top.angle));
    Simulation sim = top.bench(rate * up_B + spin * Vector3d::UnitZ()).simulation("auto", 0.01);
    for (int i = 0; i < 1000; ++i) sim.step();
    const auto about = [](double turned, const Vector3d& axis) {
      return Quaterniond(Eigen::AngleAxisd(std::remainder(turned, 4 * std::acos(-1.0)), axis));
    };
    const Quaterniond expected = about(rate * sim.time(), Vector3d::UnitZ()) *
                                 about(top.angle, Vector3d::UnitX()) *
                                 about(spin * sim.time(), Vector3d::UnitZ());
    const Quaterniond q = toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB;
    EXPECT_LT(angleBetween(q, expected), 2e-12) << rate;
  }
}

// cos θ = u₁ + (u₀ − u₁) sn²(n t + K), in the first half of the first nutation: F(φ) = K − n t.
TEST(HeavyTop, NodsByAnEllipticFunction) {
  const Top top;
  const double u_0 = std::cos(top.angle), b = 2 * top.mgc / top.I_t;
  const double a = top.I_3 * top.w_3 / top.I_t;
  // (1 − u²) b = a² (u₀ − u)
  const double p = a * a / b, q = a * a * u_0 / b - 1, root = std::sqrt(p * p / 4 - q);
  const double u_3 = p / 2 + root, u_1 = q / u_3;
  const double k = std::sqrt((u_0 - u_1) / (u_3 - u_1)), n = 0.5 * std::sqrt(b * (u_3 - u_1));
  Simulation sim = top.bench({0, 0, top.w_3}).simulation("auto", 0.005);
  int compared = 0;
  while (n * (sim.time() + 0.005) < std::comp_ellint_1(k)) {
    sim.step();
    const double sn = std::sqrt((heightOf(sim) - u_1) / (u_0 - u_1));
    if (sn > 0.95 || sn < 0.1) continue;  // time from a place where it hardly nods has few digits
    EXPECT_NEAR(std::ellint_1(k, std::asin(sn)), std::comp_ellint_1(k) - n * sim.time(), 1e-12);
    ++compared;
  }
  EXPECT_GT(compared, 20);
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
