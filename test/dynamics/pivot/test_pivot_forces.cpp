#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/wrench_in_frames.hpp>

#include "support/method_cases.hpp"

/// Motors, sensors and laws on bodies on a pivot.
namespace rigid_body_sim {
namespace {

using test::Bench;

const MassProperties kTable{4, {0.1, -0.2, 0.3}, Vector3d(1, 1.2, 1.9).asDiagonal()};

Bench tableOn(const Vector3d& pivot_B, const std::vector<Actuator>& actuators = {}) {
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  bench.add(makeBody("table", kTable, actuators, pivot_B),
            test::tumbling({0, 0, 0}, {0.2, -0.4, 0.7}));
  return bench;
}

Simulation advancedBy(const Bench& bench, const char* integrator, double h, int steps) {
  Simulation sim = bench.simulation(integrator, h);
  for (int i = 0; i < steps; ++i) sim.step();
  return sim;
}

ImuReading readingAt(const Simulation& sim, const Vector3d& position_B) {
  Imu imu;
  imu.name = "imu";
  imu.position_B = position_B;
  imu.rate = 100;
  return readImu(imu, sim.world().bodies[0], sim.motions({0}, sim.time())[0]);
}

}  // namespace

// A thruster that follows at once is a force held in the body; the pivot takes up the same.
TEST(Pivot, TakesUpThrustAsAForceOfTheBody) {
  Thruster thruster;
  thruster.position_B = {0.4, 0.1, 0};
  thruster.direction_B = {0, 0.6, 0.8};
  Bench driven = tableOn({0, 0, 0}, {Actuator{"jet", thruster}});
  driven.world.commands = {ActuatorCommand{0, 0, 3}};
  Bench pushed = tableOn({0, 0, 0});
  pushed.world.wrenches = {wrenchInBodyAxes(pushed.world.bodies, 0, 3 * thruster.direction_B,
                                            Vector3d::Zero(), thruster.position_B)};
  const auto forceOf = [](const Simulation& sim) {
    return pivotForceOf(sim.world().bodies[0], sim.motions({0}, sim.time())[0]);
  };
  for (const char* integrator : {"auto", "rk4", "dop853"}) {
    const Simulation a = advancedBy(driven, integrator, 0.01, 200);
    const Simulation b = advancedBy(pushed, integrator, 0.01, 200);
    EXPECT_LT(angleBetween(a.body(0).q_WP, b.body(0).q_WP), 1e-12) << integrator;
    EXPECT_LT((forceOf(a) - forceOf(b)).norm(), 1e-11) << integrator;
    EXPECT_EQ(a.body(0).x_W, driven.initial.bodies[0].x_W) << integrator;
    EXPECT_EQ(a.body(0).p_W, Vector3d::Zero()) << integrator;
  }
}

TEST(AirBearingTable, KeepsTheBitsOfItsMomentumWhateverItsWheelDoes) {
  Wheel wheel;
  wheel.axis_B = {0, 0.6, 0.8};
  wheel.inertia = 0.05;
  wheel.speed = 40;
  Bench bench = tableOn(kTable.com_B, {Actuator{"wheel", wheel}});
  bench.world.commands = {ActuatorCommand{0, 0, 0.3, 0.1}, ActuatorCommand{0, 0, -0.2, 0.5}};
  Simulation sim = bench.simulation("auto", 0.01);
  const Vector3d start = sim.body(0).L_W;
  for (int i = 0; i < 200; ++i) sim.step();
  EXPECT_EQ(sim.body(0).L_W, start);
  EXPECT_GT((sim.body(0).L_P - bench.initial.bodies[0].L_P).norm(), 0.1);
}

// −ω² r and +g upwards, whatever supports the table.
TEST(Imu, ReadsTheCentripetalAccelerationOnAnAirBearingTable) {
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  bench.add(makeBody("table", kTable, {}, kTable.com_B), test::tumbling({0, 0, 0}, {0, 0, 3}));
  for (const char* integrator : {"auto", "rk4"}) {
    const Simulation sim = advancedBy(bench, integrator, 0.01, 50);
    const Vector3d r(0.5, -0.3, 0.2);
    const ImuReading reading = readingAt(sim, kTable.com_B + r);
    EXPECT_LT((reading.f_S - Vector3d(-9 * r.x(), -9 * r.y(), 10)).norm(), 1e-13) << integrator;
    EXPECT_LT((reading.w_S - Vector3d(0, 0, 3)).norm(), 1e-14) << integrator;
  }
}

// At the pivot it reads +g, in axes that turn.
TEST(Imu, ReadsGravityAloneAtThePivot) {
  const Simulation sim = advancedBy(test::bodyHungOnPivoted(), "auto", 0.01, 50);
  const Body& body = sim.world().bodies[0];
  const Vector3d f_S = readingAt(sim, body.X_BP.translation()).f_S;
  const Vector3d up_B =
      toBodyFrameMotion(body, sim.body(0)).q_WB.toRotationMatrix().transpose().col(2);
  EXPECT_LT((f_S - 9.81 * up_B).norm(), 1e-13);
}

// A spring hangs a body on one that is on a pivot: the pivot bears what both lack to fall freely.
TEST(Pivot, BearsWhatASpringPullsAt) {
  for (const char* integrator : {"auto", "rk4", "kahan_li8"}) {
    const Simulation sim = advancedBy(test::bodyHungOnPivoted(), integrator, 0.01, 20);
    const auto motions = sim.motions({0, 1}, sim.time());
    const std::vector<Body>& bodies = sim.world().bodies;
    const Vector3d change =
        bodies[0].mass * accelerationOf(bodies[0], motions[0], bodies[0].com_P) +
        bodies[1].mass * accelerationOf(bodies[1], motions[1], bodies[1].com_P);
    const Vector3d weight = 3 * sim.world().g_W;
    EXPECT_LT((pivotForceOf(bodies[0], motions[0]) + weight - change).norm(), 1e-12) << integrator;
  }
}

}  // namespace rigid_body_sim
