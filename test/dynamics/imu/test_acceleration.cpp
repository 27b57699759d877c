#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "support/contact_benches.hpp"
#include "support/law_benches.hpp"
#include "support/motor_benches.hpp"

namespace rigid_body_sim {

using test::Bench;

namespace {

const Vector3d kPlace(0.3, -0.2, 0.15);  // of the sensor, principal axes

/// Velocity of the place, world axes, by matrices.
Vector3d velocityOfPlace(const Body& body, const BodyState& s) {
  const Vector3d w_P = s.L_P.cwiseQuotient(body.I);
  return s.p_W / body.mass + s.q_WP.toRotationMatrix() * w_P.cross(kPlace);
}

/// Of angular velocity, world axes.
Vector3d turningOf(const Body& body, const BodyState& s) {
  return s.q_WP.toRotationMatrix() * s.L_P.cwiseQuotient(body.I);
}

/// Derivative in the middle of nine values that are h apart, of order 8.
Vector3d derivative(const Vector3d* v, double h) {
  return (4.0 / 5 * (v[1] - v[-1]) - 1.0 / 5 * (v[2] - v[-2]) + 4.0 / 105 * (v[3] - v[-3]) -
          1.0 / 280 * (v[4] - v[-4])) /
         h;
}

/// Greatest distance of the accelerations of the next `count` steps from differences of velocities,
/// relative to the greatest of them.
struct Gaps {
  double linear = 0, angular = 0;
};

Gaps gapsOver(Simulation& sim, std::size_t index, std::size_t count) {
  const Body& body = sim.world().bodies[index];
  std::vector<Vector3d> v, w, a, alpha;
  for (std::size_t i = 0; i < count; ++i, sim.step()) {
    const BodyMotion motion = sim.motions({index}, sim.time())[0];
    v.push_back(velocityOfPlace(body, motion.state));
    w.push_back(turningOf(body, motion.state));
    a.push_back(accelerationOf(body, motion, kPlace));
    alpha.push_back(motion.state.q_WP.toRotationMatrix() * motion.acceleration.w_dot_P);
  }
  const double h = sim.world().solver.time_step;
  Gaps gaps;
  double a_most = 0, alpha_most = 1;
  for (std::size_t i = 4; i + 4 < count; ++i) {
    gaps.linear = std::max(gaps.linear, (a[i] - derivative(&v[i], h)).norm());
    gaps.angular = std::max(gaps.angular, (alpha[i] - derivative(&w[i], h)).norm());
    a_most = std::max(a_most, a[i].norm());
    alpha_most = std::max(alpha_most, alpha[i].norm());
  }
  return {gaps.linear / a_most, gaps.angular / alpha_most};
}

void expectDerivative(Simulation sim, std::size_t body, std::size_t count = 100) {
  const Gaps gaps = gapsOver(sim, body, count);
  EXPECT_LT(gaps.linear, 1e-11);
  EXPECT_LT(gaps.angular, 1e-11);
}

void expectDerivative(const Bench& bench, const std::string& integrator, double h = 1e-3) {
  for (std::size_t body = 0; body < bench.world.bodies.size(); ++body)
    expectDerivative(bench.simulation(integrator, h), body);
}

}  // namespace

TEST(Acceleration, IsTheDerivativeOfVelocityUnderHeldWrenches) {
  for (const std::size_t axes : {kWorld, std::size_t{0}})
    for (const std::size_t point_frame : {kWorld, std::size_t{0}}) {
      const Bench bench = test::pushedBox(axes, point_frame, 0.3);
      for (const char* integrator : {"auto", "dop853"}) expectDerivative(bench, integrator);
    }
}

TEST(Acceleration, IsTheDerivativeOfVelocityUnderWrenchesThatTurnWithAnotherBody) {
  Bench bench = test::springPair(0.2);
  PointWrench push = test::worldForce({1, 2, -1}, 0, 10);
  push.body = push.point_frame = 1;
  push.axes = 0;
  push.point = {0.1, 0, 0.2};
  bench.world.wrenches.push_back(push);
  expectDerivative(bench, "dop853");
}

TEST(Acceleration, IsTheDerivativeOfVelocityUnderLaws) {
  for (const Bench& bench :
       {test::boxOnSpring(0.4), test::satellite(), test::thrown({0.3, 0.2, 0.4})})
    expectDerivative(bench, "dop853");
}

TEST(Acceleration, IsTheDerivativeOfVelocityUnderMotors) {
  Bench bench = test::benchOf(test::motley(), test::motleyStart());
  bench.world.commands = {test::commandOf(0, 5, 0), test::commandOf(1, 40, 0),
                          test::commandOf(2, 0.3, 0), test::commandOf(3, -0.2, 0)};
  for (const char* integrator : {"auto", "dop853"}) expectDerivative(bench, integrator);
}

TEST(Acceleration, IsTheDerivativeOfVelocityInContact) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  // slips from touch to release: no force jumps meanwhile
  test::addBall(bench, 0.2, 1, test::motionAt({0, 0, 0.2}, {5, 0, -1}, {1, 2, 3}), test::slope(0.1),
                test::contactOf(1e5, 1.5, 0.2, 0.1));
  Simulation sim = bench.simulation("auto", 5e-5);
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_GT(sim.motions({0}, sim.time())[0].acceleration.felt_W.norm(), 15);
  expectDerivative(sim, 0, 200);
}

TEST(Acceleration, IsWhatHoldsAfterAnEventAtItsInstant) {
  Bench bench = test::restingBox();
  bench.world.wrenches.push_back(test::worldForce({4, 0, 0}, 0.0105, 0.0205));
  bench.world.wrenches.push_back(test::worldForce({0, 6, 0}, 0.03, 1));
  for (const char* integrator : {"auto", "dop853"}) {
    Simulation sim = bench.simulation(integrator, 0.01);
    const auto feltAt = [&sim](double t) { return sim.motions({0}, t)[0].acceleration.felt_W; };
    EXPECT_EQ(feltAt(0), Vector3d::Zero());
    sim.step();
    EXPECT_EQ(feltAt(std::nextafter(0.0105, 0)), Vector3d::Zero());
    EXPECT_EQ(feltAt(0.0105), Vector3d(2, 0, 0));
    sim.step();
    EXPECT_EQ(feltAt(std::nextafter(0.0205, 0)), Vector3d(2, 0, 0));
    EXPECT_EQ(feltAt(0.0205), Vector3d::Zero());
    sim.step();
    EXPECT_EQ(feltAt(sim.time()), Vector3d(0, 3, 0));
  }
}

TEST(Acceleration, LeavesTheRunAsItIs) {
  const Bench bench = test::springPair(0.2);
  Simulation asked = bench.simulation("dop853", 0.01), other = bench.simulation("dop853", 0.01);
  for (int i = 0; i < 50; ++i) {
    asked.motions({0, 1}, asked.time() + 0.003);
    asked.step();
    other.step();
  }
  for (const std::size_t body : {0, 1}) {
    EXPECT_EQ(asked.body(body).x_W, other.body(body).x_W);
    EXPECT_EQ(asked.body(body).L_W, other.body(body).L_W);
  }
}

TEST(Acceleration, OfABodyThatATouchWillLinkIsThatOfASampleInContact) {
  // within a step in which the ball touches the plane, as with steps that are short
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  test::addBall(bench, 0.2, 1, test::motionAt({0, 0, 0.25}, {0, 0, -1}), test::slope(0),
                test::contactOf(1e4, 1.5, 0.2, 0));
  Simulation fine = bench.simulation("auto", 1e-4), coarse = bench.simulation("auto", 0.1);
  while (fine.time() < 0.0545) fine.step();
  const Vector3d a = fine.motions({0}, fine.time())[0].acceleration.felt_W;
  const Vector3d b = coarse.motions({0}, fine.time())[0].acceleration.felt_W;
  EXPECT_GT(a.z(), 10);
  EXPECT_LT((a - b).norm(), 1e-6 * a.norm());
}

}  // namespace rigid_body_sim
