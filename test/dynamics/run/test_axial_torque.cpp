#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/math/rotation.hpp>

#include "support/worlds.hpp"

/// A body that turns about a principal axis under a steady torque along it: however fast it has
/// come to turn, its motion is known in closed form.
namespace rigid_body_sim {
namespace {

const Vector3d kSpunMoments(0.7, 1.1, 1.3);  // [kg m²]
constexpr double kSpinUpTime = 1e4;          // [s]
constexpr double kSpinUpTorque = 0.3;        // [N m]
constexpr double kSpinUpSpeed = -2.5;        // [rad/s] at the start

test::Bench spunBench(const Vector3d& w_P, const Quaterniond& q_WP) {
  test::Bench bench;
  bench.world.g_W = {0.1, 0, -9.81};
  bench.add(test::principalBody("wheel", 2, kSpunMoments), test::tumbling({1, 2, 3}, w_P, q_WP));
  return bench;
}

PointWrench spinUpCouple(std::size_t axes, const Vector3d& torque) {
  PointWrench wrench;
  wrench.axes = axes;
  wrench.point_frame = kOwnBody;
  wrench.torque = torque;
  wrench.end = INFINITY;
  return wrench;
}

Simulation spunUp(const test::Bench& bench, const PointWrench& couple, int steps) {
  Simulation sim = bench.simulation("auto", kSpinUpTime / steps);
  sim.trackBalance();
  sim.applyWrench("couple", couple);
  for (int i = 0; i < steps; ++i) sim.step();
  return sim;
}

/// The start turned about a principal axis by (L₀ t + τ t²/2)/I: two million turns and more.
Quaterniond spunAttitude(const BodyState& start, int axis) {
  const long double t = kSpinUpTime, I = kSpunMoments(axis), L_0 = start.L_P(axis);
  const long double angle = (L_0 * t + kSpinUpTorque * t * t / 2) / I;
  const long double half = std::fmod(angle / 2, 2 * 3.14159265358979323846264338327950288L);
  Quaterniond turn(static_cast<double>(std::cos(half)), 0, 0, 0);
  turn.vec()(axis) = static_cast<double>(std::sin(half));
  return product(start.q_WP, turn);
}

double spunAngleBetween(const Quaterniond& a, const Quaterniond& b) {
  return 2 * product(Quaterniond(a.conjugate()), b).vec().norm();
}

}  // namespace

TEST(AxialTorque, TurnsABodyByTheClosedFormHoweverFast) {
  const Quaterniond turned = Quaterniond(0.5, -0.1, 0.7, 0.3).normalized();
  for (int axis = 0; axis < 3; ++axis) {
    Quaterniond q_0 = turned;
    if (axis == 1) q_0.setIdentity();  // no rounding may be added: the body would not hold the axis
    const Vector3d e = Vector3d::Unit(axis);
    const Simulation sim =
        spunUp(spunBench(kSpinUpSpeed * e, q_0), spinUpCouple(kOwnBody, kSpinUpTorque * e), 1000);
    const BodyState state = sim.state().bodies[0];
    const BodyState start = spunBench(kSpinUpSpeed * e, q_0).initial.bodies[0];
    EXPECT_LE(spunAngleBetween(state.q_WP, spunAttitude(start, axis)), 2e-12);
    const double gained = kSpinUpTorque * kSpinUpTime;
    EXPECT_LE((state.L_P - start.L_P - gained * e).norm(), 1e-15 * gained);
    EXPECT_LE((state.L_W - start.L_W - gained * rotate(q_0, e)).norm(), 4e-15 * gained);
    EXPECT_LE((state.p_W - start.p_W - 2 * kSpinUpTime * Vector3d(0.1, 0, -9.81)).norm(), 1e-9);
    // the couple works by its torque over the angle; 1e7 J
    EXPECT_LE(std::abs(sim.balance().energy), 1e-6);
  }
}

TEST(AxialTorque, MayBeFixedInTheWorld) {
  const test::Bench bench = spunBench(kSpinUpSpeed * Vector3d::UnitZ(), Quaterniond::Identity());
  const Simulation sim = spunUp(bench, spinUpCouple(kWorld, {0, 0, kSpinUpTorque}), 10);
  const Quaterniond expected = spunAttitude(bench.initial.bodies[0], 2);
  EXPECT_LE(spunAngleBetween(sim.state().bodies[0].q_WP, expected), 2e-12);
}

TEST(AxialTorque, GoesOnToTheSameMotionWhereAnotherCoupleEndsIt) {
  // once about an axis, then about another: there, and from the start, a series follows
  const Vector3d e = Vector3d::UnitZ();
  const auto turned = [&](const Vector3d& w_P) {
    Simulation sim = spunBench(w_P, Quaterniond::Identity()).simulation("auto", 0.1);
    PointWrench along = spinUpCouple(kOwnBody, kSpinUpTorque * e);
    along.end = 1;
    sim.applyWrench("along", along);
    PointWrench across = spinUpCouple(kOwnBody, {0.2, 0, 0});
    across.start = 1;
    sim.applyWrench("across", across);
    for (int i = 0; i < 30; ++i) sim.step();
    return sim.state().bodies[0];
  };
  const BodyState closed = turned(kSpinUpSpeed * e), series = turned({1e-14, 0, kSpinUpSpeed});
  EXPECT_LE(spunAngleBetween(closed.q_WP, series.q_WP), 2e-13);
  EXPECT_LE((closed.L_P - series.L_P).norm(), 2e-13);
}

}  // namespace rigid_body_sim
