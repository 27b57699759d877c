#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "dynamics/contact/feature.hpp"
#include "support/contact_benches.hpp"

/// Touches and releases that are reported.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

/// A ball that meets the ground after 0.1 s and leaves it 0.03 s later.
Bench fallingBall() {
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  test::addBall(bench, 0.1, 1, motionAt({0, 0, 0.15005}), HalfSpace{}, contactOf(1e4, 1, 0, 0));
  return bench;
}

void expectSameEvents(const std::vector<ContactEvent>& a, const std::vector<ContactEvent>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].t, b[i].t);
    EXPECT_EQ(a[i].touch, b[i].touch);
  }
}

TEST(ContactEvents, AreNoneOfAnEarlierStepWhereAStateIsSet) {
  Simulation sim = fallingBall().simulation("auto", 0.01);
  std::size_t events = 0;
  while (events < 2) {
    sim.step();
    events += sim.contactEvents().size();
  }
  for (int i = 0; i < 5; ++i) sim.step();  // in the air again, long before the next touch
  ASSERT_TRUE(sim.contactEvents().empty());
  sim.setState(0, sim.body(0));
  EXPECT_TRUE(sim.contactEvents().empty());
}

TEST(ContactEvents, StayWhereAStepIsTakenBack) {
  Simulation sim = fallingBall().simulation("auto", 0.01);
  while (sim.contactEvents().empty()) sim.step();
  const std::vector<ContactEvent> events = sim.contactEvents();
  ASSERT_EQ(events.size(), 1u);  // it is in contact, and stays so over the next step
  PointWrench push;
  push.force = {1e308, 0, 0};
  push.end = 1;
  sim.applyWrench("push", push);
  EXPECT_THROW(sim.step(), SimulationDiverged);
  expectSameEvents(sim.contactEvents(), events);
}

/// A body of 1 kg that is about to rock on the ground: by its corners, by two balls or by two rims;
/// it turns slowly, its lowest point as deep as it is at rest.
Bench rockingBody(int shape, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  BodyFrameMotion motion = motionAt(vector(), 0.1 * vector(), 0.5 * vector());
  motion.q_WB = rotationExp(Vector3d(3 * vector()));
  ContactShape of_body;
  const Body body = test::principalBody("body", 1, {1e-3, 1.2e-3, 1.7e-3});
  if (shape == 0) of_body = test::cornersOf(body, {0.1, 0.16, 0.24});
  if (shape == 1) of_body.balls = {{{0, 0, 0.1}, 0.05}, {{0, 0, -0.1}, 0.05}};
  if (shape == 2)
    of_body.rims = {{{0, 0, 0.05}, Vector3d::UnitZ(), 0.1},
                    {{0, 0, -0.05}, Vector3d::UnitZ(), 0.1}};
  const ContactParameters c = contactOf(1e8, 1.5, 0.3, 0.5);
  double below = 0;
  for (const Feature& feature : featuresOf(of_body, "body"))
    below = std::max(below, support(feature, rotateBack(motion.q_WB, Vector3d(0, 0, -1))));
  motion.x_W.z() = below - std::pow(9.81 / c.stiffness, 1 / c.exponent);
  bench.add(body, motion);
  bench.world.laws.push_back(contactWithHalfSpace(bench.world.bodies, 0, of_body, HalfSpace{}, c));
  bench.initial.contact_bound = 1e-9;
  return bench;
}

// What has just let go lies on the plane, up to rounding: the flight that begins there must not
// touch again at once.
TEST(ContactEvents, DoNotUndoOneAnotherByRounding) {
  std::mt19937 random(16);
  int touches = 0, undone = 0;
  for (int scene = 0; scene < 24; ++scene) {
    Simulation sim = rockingBody(scene % 3, random).simulation("auto", 0.01);
    ContactEvent last;
    while (sim.steps() < 30) {
      sim.step();
      for (const ContactEvent& event : sim.contactEvents()) {
        touches += event.touch;
        undone += event.touch != last.touch && event.t - last.t < 1e-13;
        last = event;
      }
    }
  }
  EXPECT_GT(touches, 200);
  EXPECT_EQ(undone, 0);
}

// Without weight, bodies lie on a plane exactly and slide and turn along it: their depths are
// rounding for ever. They need not do so at any cost, nor does the rounding throw them off.
TEST(ContactEvents, AreFewWhereDepthsAreRounding) {
  for (const double tilt : {0.0, 0.3}) {
    HalfSpace plane = test::slope(tilt);
    const auto inWorld = [&plane](double x, double y, double z) {
      return rotate(plane.q_WH, Vector3d(x, y, z));
    };
    BodyFrameMotion motion = motionAt({0.3, -0.7, 0.2}, inWorld(0.5, 0.25, 0), inWorld(0, 0, 7));
    motion.q_WB = plane.q_WH * rotationExp(Vector3d(M_PI / 2, 0, 0));
    plane.origin_W = motion.x_W - inWorld(0, 0, 0.05);
    Bench bench;
    bench.add(test::principalBody("capsule", 1, {1e-3, 1e-3, 1e-3}), motion);
    ContactShape capsule;
    capsule.balls = {{{0, 0, 0.1}, 0.05}, {{0, 0, -0.1}, 0.05}};
    bench.world.laws.push_back(
        contactWithHalfSpace(bench.world.bodies, 0, capsule, plane, contactOf(1e6, 1.5, 0.1, 0)));
    Simulation sim = bench.simulation("auto", 0.01);
    std::size_t events = sim.contactEvents().size();
    while (sim.steps() < 50) {
      sim.step();
      events += sim.contactEvents().size();
    }
    EXPECT_LT(events, 100u) << tilt;
    EXPECT_LT(sim.evaluations(), 500000) << tilt;
    EXPECT_NEAR(sim.body(0).p_W.dot(inWorld(0, 0, 1)), 0, 1e-13) << tilt;
  }
}

}  // namespace
}  // namespace rigid_body_sim
