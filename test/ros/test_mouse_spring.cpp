#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "ros/mouse/mouse_spring.hpp"

namespace rigid_body_sim {
namespace {

/// A rod along x, 3 kg and 2 m long, thin.
Body rod() {
  Body body =
      makeBody("rod", {3, Vector3d::Zero(), Vector3d(1e-4, 1, 1).asDiagonal().toDenseMatrix()});
  EXPECT_TRUE(body.I.isApprox(Vector3d(1e-4, 1, 1)));
  return body;
}

/// A body without gravity that a spring pulls, renewed at every step as the node does.
struct PulledBody {
  PulledBody(const Body& body, const BodyState& initial, double h)
      : simulation(worldOf(body, h), {0, {initial}}) {}

  static World worldOf(const Body& body, double h) {
    World world;
    world.bodies = {body};
    world.solver.time_step = h;
    return world;
  }

  const Body& body() const { return simulation.world().bodies[0]; }
  BodyState state() const { return simulation.body(0); }

  void step() {
    PointWrench pull = pullOf(spring, body(), state(), simulation.world().solver.time_step);
    pull.start = simulation.time();
    simulation.applyWrench("mouse", pull);
    simulation.step();
  }

  /// Energy of the body and of the spring, at ω of the spring [J].
  double energy(double w) const {
    const Vector3d stretch = spring.goal_W - state().x_W - rotate(state().q_WP, spring.point_P);
    return kineticEnergy(body(), state()) +
           0.5 * massAtPoint(body(), spring.point_P) * w * w * stretch.squaredNorm();
  }

  Simulation simulation;
  MouseSpring spring;
};

}  // namespace

TEST(MouseSpring, MassAtAPointIsWhatAForceThereFinds) {
  const Body body = rod();
  EXPECT_DOUBLE_EQ(massAtPoint(body, Vector3d::Zero()), 3);
  // at the end: 1/m along the rod, 1/m + l²/(4 I) = 4/m across it, twice
  EXPECT_NEAR(massAtPoint(body, Vector3d(1, 0, 0)), 3 / (1 / 3. + 4 / 3. + 4 / 3.), 1e-12);
}

TEST(MouseSpring, PullIsASpringWithCriticalDampingAtThePoint) {
  const Body body = rod();
  BodyState state;
  state.x_W = Vector3d(5, 6, 7);
  state.q_WP = Quaterniond(std::sqrt(0.5), 0, 0, std::sqrt(0.5));  // the rod along y
  state.p_W = Vector3d(3, 0, 0);                                   // 1 m/s
  state.L_W = state.L_P = Vector3d(0, 0, 2);                       // 2 rad/s
  MouseSpring spring;
  spring.point_P = Vector3d(1, 0, 0);
  spring.goal_W = Vector3d(5, 7, 7.5);  // 0.5 m above the end
  const PointWrench pull = pullOf(spring, body, state, 1e-3);
  EXPECT_EQ(pull.axes, kWorld);
  EXPECT_EQ(pull.point_frame, 0U);
  EXPECT_EQ(pull.point, spring.point_P);
  // the end is at rest along y and z; along x it moves at 1 m/s − 2 rad/s · 1 m
  const double m = massAtPoint(body, spring.point_P);
  const Vector3d expected(-2 * m * 10 * (1 - 2), 0, m * 100 * 0.5);
  EXPECT_LT((pull.force - expected).norm(), 1e-12);
}

TEST(MouseSpring, PullsTheCentreOfMassAsACriticallyDampedSpringDoes) {
  // 1 m off and at rest:  x = 1 − (1 + ω t) exp(−ω t); held over steps of 1e-4 s, the force is late
  // by half a step, that is by ω h/2 = 5e-4 of itself
  PulledBody pulled(rod(), BodyState(), 1e-4);
  pulled.spring.goal_W = Vector3d(0, 1, 0);
  for (int i = 1; i <= 5000; ++i) {
    pulled.step();
    const double wt = 10 * pulled.simulation.time();
    EXPECT_NEAR(pulled.state().x_W.y(), 1 - (1 + wt) * std::exp(-wt), 1e-3);
  }
  EXPECT_EQ(pulled.state().L_W, Vector3d::Zero());
}

TEST(MouseSpring, NeverAddsEnergyHoweverLongTheStep) {
  for (double h : {1e-3, 0.02, 0.1, 1.0}) {
    const double w = std::min(10.0, 0.2 / h);
    for (const Vector3d& point : {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0.3, 5, -20)}) {
      BodyState state;
      state.L_W = state.L_P = Vector3d(0, 0, 0.2 * w);
      PulledBody pulled(rod(), state, h);
      pulled.spring.point_P = point;
      pulled.spring.goal_W = point + Vector3d(0.3, -0.2, 0.1);
      const double start = pulled.energy(w);
      double last = start;
      for (int i = 0; i < 300; ++i) {
        pulled.step();
        const double now = pulled.energy(w);
        // from rest a force that is held over a step adds (ω h)⁴/4 of the energy of the spring
        EXPECT_LE(now, last + 4.1e-4 * start) << "h " << h << " point " << point.transpose();
        last = now;
      }
      EXPECT_LT(last, start);
    }
  }
}

}  // namespace rigid_body_sim
