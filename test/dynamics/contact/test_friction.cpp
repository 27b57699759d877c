#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/contact_benches.hpp"

/// Friction, rolling, and what they dissipate.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

constexpr double kPull = 9.81;  // [m/s²]

/// A body that lies on the plane, at the depth at which `points` of its features carry it.
double restingDepth(double mass, int points, const ContactParameters& c) {
  return std::pow(mass * kPull / (points * c.stiffness), 1 / c.exponent);
}

// The angular momentum about the point of contact is conserved whatever friction does: a ball that
// grips ends at v = (5 v₀ + 2 R ω₀)/7.
TEST(Friction, MakesABallGripAtTheSpeedThatMomentumTells) {
  constexpr double R = 0.1, v0 = 2, w0 = -15;
  for (double height : {0.0, 0.3}) {
    Bench bench;
    bench.world.g_W = {0, 0, -kPull};
    const ContactParameters c = contactOf(1e5, 1.5, 0.8, 0.4);
    test::addBall(bench, R, 1, motionAt({0, 0, R + height - 1e-5}, {v0, 0, 0}, {0, w0, 0}),
                  HalfSpace{}, c);
    Simulation sim = test::simulationAt(bench, 1e-9, 0.01);
    while (sim.time() < 4) sim.step();
    const double v = (5 * v0 + 2 * R * w0) / 7;
    EXPECT_NEAR(sim.body(0).p_W.x(), v, 1e-12) << height;
    EXPECT_NEAR(toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).w_W.y(), v / R, 1e-11);
  }
}

// a = 5/7 g sin θ, but for the yielding of the bristle at the start.
TEST(Friction, LetsABallRollDownASlope) {
  constexpr double R = 0.1, kAngle = 0.2, kTime = 1;
  Bench bench;
  bench.world.g_W = {0, 0, -kPull};
  const ContactParameters c = contactOf(1e5, 1.5, 0.8, 0.5);
  const HalfSpace plane = test::slope(kAngle);
  const Vector3d n = rotate(plane.q_WH, Vector3d(0, 0, 1)),
                 down = rotate(plane.q_WH, Vector3d(1, 0, 0));
  test::addBall(bench, R, 1, motionAt((R - restingDepth(std::cos(kAngle), 1, c)) * n), plane, c);
  Simulation sim = test::simulationAt(bench, 1e-9, 0.01);
  while (sim.steps() < 100) sim.step();
  EXPECT_NEAR(sim.body(0).x_W.dot(down), 0.5 * 5 / 7 * kPull * std::sin(kAngle) * kTime * kTime,
              3 * c.breakaway);
}

// v²/(2 μ g), and short of it by what the bristle yields.
TEST(Friction, StopsABlock) {
  constexpr double kMass = 2, v0 = 1;
  Bench bench;
  bench.world.g_W = {0, 0, -kPull};
  const ContactParameters c = contactOf(1e5, 1, 1.0, 0.5);
  const Vector3d size(0.4, 0.3, 0.002);
  test::addBox(bench, size, kMass, motionAt({0, 0, 0.001 - restingDepth(kMass, 4, c)}, {v0, 0, 0}),
               HalfSpace{}, c);
  Simulation sim = test::simulationAt(bench, 1e-9, 0.01);
  while (sim.time() < 1) sim.step();
  const double way = v0 * v0 / (2 * c.friction * kPull);
  EXPECT_LT(sim.body(0).x_W.x(), way + 1e-9);
  EXPECT_GT(sim.body(0).x_W.x(), way - c.breakaway);
  EXPECT_NEAR(sim.body(0).p_W.norm(), 0, 1e-9);
}

TEST(Friction, HoldsABlockOnASlope) {
  constexpr double kAngle = 0.3;
  Bench bench;
  bench.world.g_W = {0, 0, -kPull};
  const ContactParameters c = contactOf(1e5, 1, 3.0, 0.5);
  const HalfSpace plane = test::slope(kAngle);
  BodyFrameMotion motion = motionAt((0.05 - 1e-5) * rotate(plane.q_WH, Vector3d(0, 0, 1)));
  motion.q_WB = plane.q_WH;
  test::addBox(bench, {0.4, 0.3, 0.1}, 2, motion, plane, c);
  Simulation sim = test::simulationAt(bench, 1e-9, 0.01);
  while (sim.time() < 2) sim.step();
  const Vector3d settled = sim.body(0).x_W;
  while (sim.time() < 4) sim.step();
  EXPECT_NEAR((sim.body(0).x_W - settled).norm(), 0, 1e-12);
  Vector3d carried = Vector3d::Zero();
  for (const ContactPoint& contact : contactsOf(sim.world(), sim.state())) {
    EXPECT_FALSE(contact.slips);
    carried += contact.normal_force_W + contact.friction_force_W;
  }
  EXPECT_NEAR((carried - Vector3d(0, 0, 2 * kPull)).norm(), 0, 1e-9);
}

// v²/(2 · 5/7 ρ g/R)
TEST(RollingFriction, StopsABall) {
  constexpr double R = 0.1, v0 = 0.5, rho = 2e-3;
  Bench bench;
  bench.world.g_W = {0, 0, -kPull};
  ContactParameters c = contactOf(1e5, 1.5, 0.8, 0.5);
  c.rolling_friction = rho;
  test::addBall(bench, R, 1,
                motionAt({0, 0, R - restingDepth(1, 1, c)}, {v0, 0, 0}, {0, v0 / R, 0}),
                HalfSpace{}, c);
  Simulation sim = test::simulationAt(bench, 1e-9, 0.01);
  sim.trackBalance();
  while (sim.time() < 1) sim.step();
  // the stretched bristles hold ρ m g b/(2 R) = 1e-6 J
  EXPECT_NEAR(sim.balance().energy, 0, 1e-10);
  while (sim.time() < 6) sim.step();
  EXPECT_NEAR(sim.body(0).x_W.x(), v0 * v0 / (2 * 5.0 / 7 * rho * kPull / R), 20 * c.breakaway);
  EXPECT_NEAR(sim.body(0).p_W.norm(), 0, 1e-9);
}

// torn off faster than 1/dissipation: what it was pressed in by is lost
TEST(NormalPoint, ThatIsTornOffLosesItsEnergy) {
  Bench bench;
  bench.world.g_W = {0, 0, -kPull};
  const ContactParameters c = contactOf(1e4, 1.5, 5, 0);
  test::addBall(bench, 0.1, 1, motionAt({0, 0, 0.1 - restingDepth(1, 1, c)}, {0, 0, 1}, {0, 0, 0}),
                HalfSpace{}, c);
  Simulation sim = test::simulationAt(bench, 1e-9, 0.01);
  sim.trackBalance();
  sim.step();
  const double depth = restingDepth(1, 1, c);
  const double fall = 0.5 * kPull * 0.01 * 0.01, rise = 0.01 - fall;
  // no force: it flies as if there were no ground
  EXPECT_NEAR(sim.body(0).x_W.z(), 0.1 - depth + rise, 1e-12);
  EXPECT_NEAR(sim.balance().energy, 0, 1e-12);
  EXPECT_GT(1e4 / 2.5 * std::pow(depth, 2.5), 1e-2);  // [J] is lost, and counted as lost
}

/// A box thrown on a slope, of any attitude and spin.
Bench thrownBox(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  Bench bench;
  bench.world.g_W = {0, 0, -kPull};
  BodyFrameMotion motion = motionAt({0, 0, 0.5}, 2 * vector(), 5 * vector());
  motion.q_WB = rotationExp(Vector3d(2 * vector()));
  const double exponent = uniform(random) < 0 ? 1 : 1.5;
  const double friction = 0.5 + 0.5 * uniform(random);
  test::addBox(bench, {0.3, 0.2, 0.1}, 2, motion, test::slope(0.2 * uniform(random)),
               contactOf(1e5, exponent, 0.3, friction));
  return bench;
}

TEST(ThrownBox, NeverGainsEnergy) {
  std::mt19937 random(21);
  for (int i = 0; i < 12; ++i) {
    Simulation sim = thrownBox(random).simulation("auto", 2e-3);
    double last = mechanicalEnergy(sim.world(), sim.state());
    const double scale = std::abs(last);
    while (sim.time() < 0.8) {
      sim.step();
      const double now = mechanicalEnergy(sim.world(), sim.state());
      EXPECT_LT(now - last, 1e-11 * scale) << i << ' ' << sim.time();
      last = now;
    }
  }
}

TEST(ThrownBox, DissipatesWhatTheBalanceSays) {
  std::mt19937 random(22);
  for (int i = 0; i < 3; ++i) {
    Simulation sim = thrownBox(random).simulation("auto", 2e-3);
    sim.trackBalance();
    while (sim.time() < 0.6) sim.step();
    EXPECT_LT(sim.exchanged().energy, -0.5);
    EXPECT_NEAR(sim.balance().energy, 0, 1e-8);
    EXPECT_NEAR(sim.balance().momentum.norm(), 0, 1e-8);
    EXPECT_NEAR(sim.balance().angular_momentum.norm(), 0, 1e-8);
  }
}

void expectSameBitsFrom(const Simulation& whole) {
  Simulation rest(whole.world(), whole.state()), copy = whole;
  for (int i = 0; i < 60; ++i) {
    copy.step();
    rest.step();
    ASSERT_EQ(copy.contactEvents().size(), rest.contactEvents().size());
  }
  EXPECT_EQ(rest.state().laws, copy.state().laws);
  EXPECT_EQ(rest.body(0).x_W, copy.body(0).x_W);
  EXPECT_EQ(rest.body(0).L_P, copy.body(0).L_P);
  EXPECT_EQ(rest.body(0).q_WP.coeffs(), copy.body(0).q_WP.coeffs());
}

// Wherever a run is cut, in flight, in an impact, while it slips: the same bits follow.
TEST(ThrownBox, GoesOnFromAStateWithTheSameBits) {
  std::mt19937 random(23);
  Simulation whole = thrownBox(random).simulation("auto", 1e-3);
  int touching = 0, slipping = 0;
  while (whole.steps() < 1500) {
    whole.step();
    const std::vector<ContactPoint> contacts = contactsOf(whole.world(), whole.state());
    if (contacts.empty() && whole.steps() % 200 != 0) continue;
    if (touching > 12) continue;
    touching += !contacts.empty();
    for (const ContactPoint& contact : contacts) slipping += contact.slips;
    expectSameBitsFrom(whole);
  }
  EXPECT_GT(touching, 5);
  EXPECT_GT(slipping, 2);
}

// The second run, at looser steps, is off by more than the first: what it tells is about the
// error, and it tells of flights after a contact, too.
TEST(ThrownBox, TellsItsError) {
  std::mt19937 random(25);
  for (int i = 0; i < 4; ++i) {
    const Bench bench = thrownBox(random);
    Simulation sim = test::simulationAt(bench, 1e-6, 1e-3);
    Simulation exact = test::simulationAt(bench, 1e-10, 1e-3);
    sim.trackError();
    bool touched = false;
    for (int since = 0; since < 100 || sim.steps() % 2 != 0; since += touched) {
      sim.step();
      exact.step();
      touched |= !sim.contactEvents().empty();
    }
    const double error = distanceBetween(sim.body(0), exact.body(0));
    EXPECT_GT(3 * sim.errorEstimate().position, error) << i;
    EXPECT_LT(sim.errorEstimate().position, 1e5 * error) << i;
  }
}

TEST(ThrownBox, IsTheSameUnderDop853) {
  std::mt19937 random(24);
  for (int i = 0; i < 4; ++i) {
    const Bench bench = thrownBox(random);
    Simulation solved = bench.simulation("auto", 1e-3), stepped = bench.simulation("dop853", 1e-3);
    while (solved.time() < 0.35) solved.step();
    while (stepped.time() < 0.35) stepped.step();
    EXPECT_NEAR(distanceBetween(solved.body(0), stepped.body(0)), 0, 1e-7) << i;
  }
}

}  // namespace
}  // namespace rigid_body_sim
