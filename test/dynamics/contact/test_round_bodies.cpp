#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/shapes.hpp>

#include "support/contact_benches.hpp"
#include "support/reference_contact.hpp"
#include "support/reference_contact_shapes.hpp"

/// Bodies that stand on rims, and a top that turns over.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

constexpr double kCanRadius = 0.05, kCanHeight = 0.12, kCanMass = 0.4;

/// A cylinder of the given length, by its two rims.
Bench can(double length, const BodyFrameMotion& motion, const ContactParameters& parameters) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(makeBody("can", massProperties(Cylinder{kCanRadius, length}, kCanMass)), motion);
  const Isometry3d X_PB = bench.world.bodies[0].X_BP.inverse();
  ContactShape shape;
  for (double z : {-0.5 * length, 0.5 * length})
    shape.rims.push_back({X_PB * Vector3d(0, 0, z), X_PB.linear() * Vector3d(0, 0, 1), kCanRadius});
  bench.world.laws.push_back(
      contactWithHalfSpace(bench.world.bodies, 0, shape, HalfSpace{}, parameters));
  return bench;
}

double tiltOf(const Simulation& sim) {
  const Quaterniond q_WB = toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB;
  const Vector3d a = rotate(q_WB, Vector3d(0, 0, 1));
  return std::atan2(a.cross(Vector3d(0, 0, 1)).norm(), a.z());
}

TEST(Can, StandsAsItWasDropped) {
  const ContactParameters c = contactOf(1e5, 1, 3, 0.5);
  Simulation sim =
      can(kCanHeight, motionAt({0, 0, 0.5 * kCanHeight + 0.05}), c).simulation("auto", 0.01);
  while (sim.time() < 3) sim.step();
  EXPECT_LT(tiltOf(sim), 1e-12);
  const double depth = kCanMass * 9.81 / (4 * c.stiffness);
  EXPECT_NEAR(sim.body(0).x_W.z(), 0.5 * kCanHeight - depth, 1e-9);
  EXPECT_NEAR(sim.body(0).L_P.norm(), 0, 1e-12);
}

TEST(Can, RocksUntilItStands) {
  BodyFrameMotion motion = motionAt({0, 0, 0.5 * kCanHeight + 0.02});
  motion.q_WB = rotationExp(Vector3d(0.05, 0.02, 0));
  Simulation sim = can(kCanHeight, motion, contactOf(1e5, 1.5, 2, 0.5)).simulation("auto", 0.01);
  double last = mechanicalEnergy(sim.world(), sim.state());
  while (sim.time() < 4) {
    sim.step();
    const double now = mechanicalEnergy(sim.world(), sim.state());
    EXPECT_LT(now - last, 1e-13);
    last = now;
  }
  // measured: 7e-6 rad are left at 4 s
  EXPECT_LT(tiltOf(sim), 1e-4);
}

// Friction on a flat rim stops its spin: α = μ m g R/I, with I = ½ m R².
TEST(Coin, IsStoppedBySpinFriction) {
  constexpr double kSpin = 10, kFriction = 0.3, kThickness = 0.01;
  const ContactParameters c = contactOf(1e6, 1, 3, kFriction);
  const double depth = kCanMass * 9.81 / (4 * c.stiffness);
  Simulation sim =
      can(kThickness, motionAt({0, 0, 0.5 * kThickness - depth}, {0, 0, 0}, {0, 0, kSpin}), c)
          .simulation("auto", 0.01);
  const auto spin = [&] { return toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).w_W.z(); };
  while (sim.steps() < 5) sim.step();
  EXPECT_NEAR(spin(), kSpin - 2 * kFriction * 9.81 / kCanRadius * 0.05, 1e-9);
  while (sim.steps() < 40) sim.step();
  EXPECT_NEAR(spin(), 0, 1e-9);
  EXPECT_LT(tiltOf(sim), 1e-12);
}

// A disk that rolls in a circle about its own centre of mass, which stands still at the height at
// which its weight presses it in: with α its tilt, h half its thickness, û along its face to the
// lowest point and a its axis,
//   ω = ω_u (û − h/R a),   ω_u² = m g sin α (R cos α − h sin α)/(I_t cos α − I_a sin α h/R)
// follows from L' = r × m g n. The point of contact has no velocity, so that friction does nothing.
TEST(Disk, TurnsSteadilyAboutItsCentre) {
  constexpr double kHalf = 0.005, kTilt = 0.3, kGravity = 9.81;
  const double s = std::sin(kTilt), c = std::cos(kTilt);
  for (const double stiffness : {1e4, 1e8}) {
    BodyFrameMotion motion;
    motion.q_WB = rotationExp(Vector3d(0, kTilt, 0));
    const double depth = std::pow(kCanMass * kGravity / stiffness, 1 / 1.5);
    motion.x_W.z() = kHalf * c + kCanRadius * s - depth;
    Bench bench = can(2 * kHalf, motion, contactOf(stiffness, 1.5, 0.3, 0.5));
    const double I_a = kCanMass * kCanRadius * kCanRadius / 2;
    const double I_t = I_a / 2 + kCanMass * kHalf * kHalf / 3;
    const double w = std::sqrt(kCanMass * kGravity * s * (kCanRadius * c - kHalf * s) /
                               (I_t * c - I_a * s * kHalf / kCanRadius));
    motion.w_W = w * (Vector3d(c, 0, -s) - kHalf / kCanRadius * Vector3d(s, 0, c));
    bench.initial.bodies[0] = toBodyState(bench.world.bodies[0], motion);
    Simulation sim = test::simulationAt(bench, 1e-10, 0.01);
    double worst = 0;
    while (sim.time() < 1) {
      sim.step();
      const double off = (sim.body(0).x_W + sim.body(0).x_low_W - motion.x_W).norm();
      worst = std::max({worst, off / kCanRadius, std::abs(tiltOf(sim) - kTilt)});
    }
    EXPECT_LT(worst, 1e-12) << stiffness;
    // it precesses at ω_u/sin α
    const Vector3d a = rotate(toBodyFrameMotion(bench.world.bodies[0], sim.body(0)).q_WB,
                              Vector3d(Vector3d::UnitZ()));
    const double angle = -w / s * sim.time();
    EXPECT_NEAR(std::remainder(std::atan2(a.y(), a.x()) - angle, 2 * M_PI), 0, 1e-10);
  }
}

/// [rad] The tilts of the same top at 0.75 and 1.75 s, by the independent reference.
std::pair<double, double> tiltsOfReference(double m, double R, double offset, double gravity,
                                           const ContactParameters& c) {
  using contact_reference::Real;
  using contact_reference::Vec;
  contact_reference::Scene scene;
  scene.g = Vec(0, 0, -Real(gravity));
  scene.contact_step = 2e-5L;
  const Real across = 0.374286L * m * R * R, along = 0.4L * m * R * R;
  scene.bodies.push_back({m, Vec(across, across, along)});
  scene.elements.push_back(
      contact_reference::ball(0, scene.bodies[0], Vec(0, 0, offset), R, {Vec::Zero(), Vec(0, 0, 1)},
                              {c.stiffness, c.exponent, c.dissipation, c.friction, c.breakaway}));
  const contact_reference::Quat q(Eigen::AngleAxis<Real>(0.1L, Vec(0, 1, 0)));
  const Real depth = std::pow(Real(m) * gravity / c.stiffness, 1 / Real(1.5L));
  std::vector<contact_reference::Pose> poses{{Vec(0, 0, R - offset * (q * Vec(0, 0, 1))[2] - depth),
                                              Vec::Zero(), q, q.conjugate() * Vec(0, 0, 155)}};
  const auto tiltAfter = [&](Real t) {
    const Vec a = scene.run(poses, t)[0].q * Vec(0, 0, 1);
    return double(std::atan2(a.cross(Vec(0, 0, 1)).norm(), a[2]));
  };
  return {tiltAfter(0.75L), tiltAfter(1.75L)};
}

// Jellett's L · r, with r the arm of the contact, is constant whatever friction does; meanwhile the
// top turns over.
TEST(TippeTop, KeepsJellettsIntegralWhileItTurnsOver) {
  constexpr double m = 0.02, R = 0.02, kOffset = 0.3 * R, kGravity = 9.82;
  Bench bench;
  bench.world.g_W = {0, 0, -kGravity};
  const double across = 0.374286 * m * R * R, along = 0.4 * m * R * R;
  const Body top =
      makeBody("top", {m, Vector3d::Zero(), Vector3d(across, across, along).asDiagonal()});
  BodyFrameMotion motion;
  motion.q_WB = rotationExp(Vector3d(0, 0.1, 0));
  const Vector3d a = rotate(motion.q_WB, Vector3d(0, 0, 1));
  motion.w_W = {0, 0, 155};
  const double depth = std::pow(m * kGravity / 1e5, 1 / 1.5);
  motion.x_W.z() = R - kOffset * a.z() - depth;
  bench.add(top, motion);
  ContactShape shape;
  shape.balls.push_back({top.X_BP.inverse() * Vector3d(0, 0, kOffset), R});
  bench.world.laws.push_back(contactWithHalfSpace(bench.world.bodies, 0, shape, HalfSpace{},
                                                  contactOf(1e5, 1.5, 0.4, 0.3)));
  Simulation sim = test::simulationAt(bench, 1e-10, 0.01);
  const auto jellett = [&] {
    const Vector3d axis = rotate(toBodyFrameMotion(top, sim.body(0)).q_WB, Vector3d(0, 0, 1));
    return sim.body(0).L_W.dot(kOffset * axis - R * Vector3d(0, 0, 1));
  };
  const double start = jellett();
  double worst = 0;
  const auto turnTo = [&](double time) {
    while (sim.time() < time - 1e-9) {
      sim.step();
      worst = std::max(worst, std::abs(jellett() / start - 1));
    }
    return tiltOf(sim);
  };
  const auto [before, after] =
      tiltsOfReference(m, R, kOffset, kGravity, contactOf(1e5, 1.5, 0.4, 0.3));
  EXPECT_NEAR(turnTo(0.75), before, 1e-6);
  EXPECT_NEAR(turnTo(1.75), after, 1e-6);
  EXPECT_GT(after, 2.8);
  EXPECT_LT(worst, 1e-12);
}

}  // namespace
}  // namespace rigid_body_sim
