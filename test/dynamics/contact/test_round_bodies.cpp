#include <cmath>

#include <gtest/gtest.h>

#include "support/contact_benches.hpp"

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
  Simulation sim = bench.simulation("auto", 0.01);
  const auto jellett = [&] {
    const Vector3d axis = rotate(toBodyFrameMotion(top, sim.body(0)).q_WB, Vector3d(0, 0, 1));
    return sim.body(0).L_W.dot(kOffset * axis - R * Vector3d(0, 0, 1));
  };
  const double start = jellett();
  double worst = 0;
  while (sim.time() < 1.2) {
    sim.step();
    worst = std::max(worst, std::abs(jellett() / start - 1));
  }
  EXPECT_GT(tiltOf(sim), 2.7);  // measured: 2.8 rad
  // what this tolerance reaches; no bound on it is derived
  EXPECT_LT(worst, 1e-11);
}

}  // namespace
}  // namespace rigid_body_sim
