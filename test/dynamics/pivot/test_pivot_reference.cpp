#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/wrench_in_frames.hpp>

#include "support/random_bodies.hpp"
#include "support/reference_pivot.hpp"
#include "support/worlds.hpp"

/// Bodies on a pivot against the equations with the pivot's force as an unknown.
namespace rigid_body_sim {
namespace {

using reference::LoadAtCom;
using reference::Motion;
using reference::Vector;
using test::Bench;

/// A force and a couple of each kind that can be held.
struct Pushes {
  Vector3d in_body, at_body, in_world, at_world_point, world_point, at_com, couple;
};

struct Trial {
  Bench bench;
  reference::PivotedBody truth;
  Motion start;
};

Pushes drawnPushes(Draw& draw) {
  Pushes pushes;
  for (Vector3d* v : {&pushes.in_body, &pushes.at_body, &pushes.in_world, &pushes.at_world_point,
                      &pushes.world_point, &pushes.at_com, &pushes.couple})
    *v = draw.vector(1);
  return pushes;
}

MassProperties drawnMass(Draw& draw) {
  const Matrix3d R = draw.attitude().toRotationMatrix();
  const Body box = draw.box(0.5);
  Matrix3d I = R * box.I.asDiagonal() * R.transpose();
  I = 0.5 * (I + I.transpose()).eval();
  return {box.mass, draw.vector(0.5), I};
}

/// What acts, in axes of B, from the attitude q_WB alone.
std::function<LoadAtCom(const Motion&)> loadOf(const MassProperties& mass, const Vector3d& g_W,
                                               const Pushes& p, const Vector3d& pivot_W,
                                               const Vector3d& point_B) {
  return [=](const Motion& m) {
    using reference::Real;
    const auto wide = [](const Vector3d& v) -> Vector { return v.cast<Real>(); };
    const reference::Matrix R_BW = m.R().transpose();
    const Vector com = wide(mass.com_B);
    LoadAtCom load;
    load.add(Real(mass.mass) * (R_BW * wide(g_W)), Vector::Zero());
    load.add(wide(p.in_body), wide(p.at_body) - com);
    load.add(R_BW * wide(p.in_world), wide(p.at_body) - com);
    load.add(R_BW * wide(p.at_com), Vector::Zero());
    load.add(R_BW * wide(p.at_world_point),
             R_BW * (wide(p.world_point) - wide(pivot_W)) + wide(point_B) - com);
    load.tau += R_BW * wide(p.couple);
    return load;
  };
}

Trial drawnTrial(unsigned seed) {
  Draw draw(seed);
  const MassProperties mass = drawnMass(draw);
  const Vector3d point_B = draw.vector(0.7), g_W = draw.vector(9.81);
  BodyFrameMotion motion;
  motion.x_W = draw.vector(2);
  motion.q_WB = draw.attitude();
  motion.w_W = draw.vector(3);
  const Pushes pushes = drawnPushes(draw);

  Trial trial;
  trial.bench.world.g_W = g_W;
  trial.bench.add(makeBody("body", mass, {}, point_B), motion);
  const std::vector<Body>& bodies = trial.bench.world.bodies;
  PointWrench at_world_point = test::worldForce(pushes.at_world_point, 0, 100);
  at_world_point.point_frame = kWorld;
  at_world_point.point = pushes.world_point;
  trial.bench.world.wrenches = {
      wrenchInBodyAxes(bodies, 0, pushes.in_body, Vector3d::Zero(), pushes.at_body),
      wrenchInWorldAxes(bodies, 0, pushes.in_world, pushes.couple, pushes.at_body),
      wrenchAtCenterOfMass(bodies, 0, pushes.at_com, Vector3d::Zero()), at_world_point};
  const Vector3d pivot_W = motion.x_W + motion.q_WB.toRotationMatrix() * point_B;
  trial.truth = {mass, point_B, loadOf(mass, g_W, pushes, pivot_W, point_B)};
  trial.start.q = motion.q_WB.cast<reference::Real>().normalized();
  trial.start.w = trial.start.R().transpose() * motion.w_W.cast<reference::Real>();
  return trial;
}

}  // namespace

// Rounding over 1 s of some 10 rad/s, grown by the motion.
TEST(Pivot, TurnsAsNewtonAndEulerSay) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Trial trial = drawnTrial(seed);
    Simulation sim = trial.bench.simulation("auto", 0.1);
    for (int i = 0; i < 10; ++i) sim.step();
    const Motion truth = reference::advancePivoted(trial.truth, trial.start, 1);
    const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
    EXPECT_LT(reference::attitudeError(m.q_WB, truth), 1e-12) << seed;
    const Vector w_W = truth.R() * truth.w;
    EXPECT_LT((m.w_W.cast<reference::Real>() - w_W).norm(), 1e-12 * w_W.norm()) << seed;
  }
}

TEST(Pivot, PushesBackAsNewtonAndEulerSay) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Trial trial = drawnTrial(seed);
    const reference::PivotSolution truth = reference::solve(trial.truth, trial.start);
    const Vector force_W = trial.start.R() * truth.force_B;
    for (const char* integrator : {"auto", "rk4", "taylor"}) {
      const Simulation sim = trial.bench.simulation(integrator, 0.1);
      const BodyMotion motion = sim.motions({0}, 0)[0];
      const Vector3d force = pivotForceOf(sim.world().bodies[0], motion);
      EXPECT_LT((force.cast<reference::Real>() - force_W).norm(), 1e-13 * force_W.norm()) << seed;
    }
  }
}

// Drag and wind at the centre of mass, as a law that is stepped.
TEST(Pivot, IsSlowedByTheMedium) {
  const Vector3d wind_W(3, -1, 2);
  const MassProperties mass{2, {0.1, 0.05, -0.4}, Vector3d(0.5, 0.7, 0.9).asDiagonal()};
  const BodyFrameMotion motion = test::tumbling({0, 0, 0}, {1, -0.7, 0.4});
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.world.solver.tolerance = 1e-11;
  bench.world.solver.horizon = 1;
  bench.add(makeBody("vane", mass, {}, Vector3d::Zero()), motion);
  MediumDrag::Coefficients drag;
  drag.linear.alike = 0.4;
  drag.quadratic.alike = 0.3;
  drag.center_P = bench.world.bodies[0].com_P;
  bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, wind_W));
  reference::PivotedBody truth{mass, Vector3d::Zero(), [&](const Motion& m) {
                                 using reference::Real;
                                 const Vector c = mass.com_B.cast<Real>();
                                 const reference::Matrix R_BW = m.R().transpose();
                                 const Vector u = m.w.cross(c) - R_BW * wind_W.cast<Real>();
                                 LoadAtCom load;
                                 load.f = R_BW * Vector(0, 0, -2 * Real(9.81)) -
                                          (Real(0.4) + Real(0.3) * u.norm()) * u;
                                 return load;
                               }};
  Motion start;
  start.w = motion.w_W.cast<reference::Real>();
  const Motion end = reference::advancePivoted(truth, start, 1);
  Simulation sim = bench.simulation("auto", 0.01);
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_EQ(sim.body(0).x_W, Vector3d::Zero());
  const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
  EXPECT_LT(reference::attitudeError(m.q_WB, end), 1e-11);
}

// m g where it hangs, and with m ω² c more where it swings through.
TEST(Pivot, CarriesTheWeightOfWhatHangs) {
  const Body body = makeBody("bob", {2, {0, 0, -0.5}, Vector3d(0.1, 0.2, 0.3).asDiagonal()}, {},
                             Vector3d::Zero());
  for (double w : {0.0, 3.0}) {
    Bench bench;
    bench.world.g_W = {0, 0, -10};
    bench.add(body, test::tumbling({0, 0, 0}, {w, 0, 0}));
    const Simulation sim = bench.simulation("auto", 0.1);
    const Vector3d force = pivotForceOf(body, sim.motions({0}, 0)[0]);
    EXPECT_LT((force - Vector3d(0, 0, 20 + w * w)).norm(), 1e-14 * 20) << w;
  }
  EXPECT_EQ(pivotForceOf(test::principalBody("free", 1, {1, 2, 3}), BodyMotion()),
            Vector3d::Zero());
}

}  // namespace rigid_body_sim
