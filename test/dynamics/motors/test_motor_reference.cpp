#include <array>
#include <cmath>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "support/ladder.hpp"
#include "support/motor_benches.hpp"

/// Motors against an independent reference (support/reference_motors.hpp).
namespace rigid_body_sim {
namespace {

using namespace test;
using reference::MotorMotion;
using reference::Wide;

BodyFrameMotion motionOf(const Simulation& sim) {
  return toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
}

/// What the four rotors are to do for a circle of 1 m at 1 rad/s: thrust along the wanted
/// acceleration, torques of a damped spring in the attitude, the yaw left alone.
std::vector<double> circleCommands(const MotorMotion& drone, double t) {
  using V = Eigen::Matrix<double, 3, 1>;
  const V x = drone.position().cast<double>(), v = drone.velocity().cast<double>();
  const V goal(std::cos(t) - 1, std::sin(t), 1), rate(-std::sin(t), std::cos(t), 0);
  const V wanted = 4 * (goal - x) + 3 * (rate - v) + V(0, 0, 9.81);
  const Quaterniond q = drone.attitude().cast<double>().normalized();
  const V axis = q.conjugate() * wanted.normalized(), w = drone.angularVelocity().cast<double>();
  const V torque = Vector3d(10e-3, 12.5e-3, 19.5e-3)
                       .cwiseProduct(V(-100 * axis.y(), 100 * axis.x(), 0) - 15 * w);
  const double k = 8.5e-6, kappa = 1.4e-7;
  const double lift = 1.2 * wanted.dot(q * V::UnitZ()) / (4 * k);
  const double roll = torque.x() / (0.8 * k), pitch = torque.y() / (0.8 * k);
  const double yaw = torque.z() / (4 * kappa);
  std::vector<double> speeds;
  for (const auto& [x_sign, y_sign, turns] :
       std::vector<std::array<int, 3>>{{1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, -1}})
    speeds.push_back(std::sqrt(std::max(1e4, lift + y_sign * roll - x_sign * pitch - turns * yaw)));
  return speeds;
}

}  // namespace

// Must hold: 1000 command changes of each rotor in 10 s, at k·10 ms + U(0, 1 ms), to 1e-12 rad.
TEST(MotorReference, QuadrotorFliesACircleOfAThousandCommands) {
  const reference::MotorBody motors = quadrotor();
  Bench bench = benchOf(motors, BodyFrameMotion());
  Simulation sim = bench.simulation("auto", 1e-3);
  MotorMotion drone(motors, BodyFrameMotion());
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> jitter(0, 1e-3);
  double reached = 0;
  for (int n = 0; n < 1000; ++n) {
    const double t = n * 0.01 + jitter(draw);
    drone.advance(Wide(t) - Wide(reached), 0.01L);
    reached = t;
    const std::vector<double> speeds = circleCommands(drone, t);
    for (std::size_t k = 0; k < 4; ++k) {
      drone.command(k, speeds[k]);
      sim.command(commandOf(k, speeds[k], t));
    }
    while (sim.steps() < 10 * (n + 1)) sim.step();
  }
  drone.advance(Wide(sim.time()) - Wide(reached), 0.01L);
  EXPECT_EQ(sim.plans()[0].integrator, "");  // solved
  EXPECT_LE(
      (drone.position() - reference::WideVector(std::cos(10.L) - 1, std::sin(10.L), 1)).norm(),
      0.5);  // it is a circle
  EXPECT_LE(reference::attitudeGap(motionOf(sim), drone), 1e-12);
  EXPECT_LE(reference::positionGap(sim.body(0), drone), 1e-11);
  EXPECT_EQ(sim.saturations(), 0);
}

// Every kind of motor at odd places, commands at odd instants, whatever the step.
TEST(MotorReference, MotorsOfEveryKindWhateverTheStep) {
  const reference::MotorBody motors = motley();
  Bench bench = benchOf(motors, motleyStart());
  bench.world.commands = {commandOf(0, 8, 0),      commandOf(1, 40, 0.1234567),
                          commandOf(2, 0.3, 0.2),  commandOf(3, -0.1, 0.25),
                          commandOf(0, -3, 0.777), commandOf(2, -0.5, 1.0001)};
  MotorMotion exact(motors, motleyStart());
  double reached = 0;
  for (const ActuatorCommand& command : bench.world.commands) {
    exact.advance(Wide(command.start) - Wide(reached), 0.05L);
    reached = command.start;
    exact.command(command.actuator, command.value);
  }
  exact.advance(2 - Wide(reached), 0.05L);
  for (const char* integrator : {"auto", "taylor"}) {
    for (int steps : {1, 7, 300}) {
      Simulation sim = bench.simulation(integrator, 2. / steps);
      for (int i = 0; i < steps; ++i) sim.step();
      const std::string what = std::string(integrator) + " in " + std::to_string(steps);
      EXPECT_LE(reference::attitudeGap(motionOf(sim), exact), 1e-13) << what;
      EXPECT_LE(reference::positionGap(sim.body(0), exact), 1e-13) << what;
      EXPECT_LE((sim.body(0).L_W - exact.momentum().cast<double>()).norm(), 1e-13) << what;
      const std::vector<ActuatorReading> readings = sim.actuators(0);
      EXPECT_NEAR(readings[0].force, double(exact.value(0)), 1e-14) << what;
      EXPECT_NEAR(readings[1].speed, double(exact.value(1)), 1e-13) << what;
      const double
          h = double(exact.value(2)),
          w = double(Vector3d(1, 2, -0.5).normalized().dot(exact.angularVelocity().cast<double>()));
      EXPECT_NEAR(readings[2].speed, h / 0.12 - w, 1e-12) << what;
    }
  }
}

// With a force at a point of the world, a lever and a couple beside.
TEST(MotorReference, HeldWrenchesActBesideMotors) {
  reference::MotorBody motors = motley();
  Bench bench = benchOf(motors, motleyStart());
  bench.world.commands = {commandOf(0, 8, 0), commandOf(2, 0.3, 0.2)};
  PointWrench push = worldForce({1, -2, 0.5}, 0, 5);
  push.point_frame = kWorld;
  push.point = {0.3, 0.2, -0.4};
  PointWrench lever = worldForce({-1, 0.3, 0.8}, 0.1, 5);
  lever.point = {0.2, 0.1, 0.4};
  PointWrench own = worldForce({0.2, 0.4, 0.1}, 0, 5);
  own.axes = kOwnBody;
  own.torque = {0.1, 0.2, -0.3};
  bench.world.wrenches = {push, lever, own};
  // dop853 at short steps shares neither the series nor the schedule of the motors' events
  const State solved = bench.run("auto", 2, 8), stepped = bench.run("dop853", 2, 2000);
  EXPECT_LE(angleBetween(solved.bodies[0].q_WP, stepped.bodies[0].q_WP), 1e-12);
  EXPECT_LE(distanceBetween(solved.bodies[0], stepped.bodies[0]), 1e-12);
  EXPECT_LE((solved.bodies[0].L_W - stepped.bodies[0].L_W).norm(), 1e-11);
}

// The claimed order, with motors that only push and with those that carry momentum.
TEST(MotorReference, IntegratorsKeepTheirOrder) {
  for (const bool spins : {false, true}) {
    reference::MotorBody motors = motley();
    if (!spins) motors.actuators.resize(2);
    if (!spins) std::get<Rotor>(motors.actuators[1].kind).inertia = 0;
    Bench bench = benchOf(motors, motleyStart());
    bench.world.commands = {commandOf(0, 8, 0), commandOf(1, 40, 0)};
    if (spins) bench.world.commands.push_back(commandOf(2, 0.3, 0));
    MotorMotion exact(motors, motleyStart());
    for (const ActuatorCommand& command : bench.world.commands)
      exact.command(command.actuator, command.value);
    exact.advance(3, 0.05L);
    for (const auto& [name, order, needs_no_spin] :
         std::vector<std::tuple<const char*, int, bool>>{{"semi_implicit_euler", 1, true},
                                                         {"strang", 2, true},
                                                         {"magnus4", 2, true},
                                                         {"rk4", 4, false},
                                                         {"dop853", 8, false}}) {
      if (spins && needs_no_spin) {
        EXPECT_THROW(bench.simulation(name, 0.01), std::invalid_argument) << name;
        continue;
      }
      Ladder attitude(1e-12);
      for (double steps = 15; steps < 2000; steps *= 1.3) {
        const int n = static_cast<int>(steps);
        Simulation sim = bench.simulation(name, 3. / n);
        for (int i = 0; i < n; ++i) sim.step();
        if (sim.maxSubsteps() > 1) continue;
        const double error = reference::attitudeGap(motionOf(sim), exact);
        attitude.add(n, error);
        if (error < 1e-12) break;
      }
      ASSERT_TRUE(attitude.slope(2)) << name;
      EXPECT_NEAR(*attitude.slope(2), order, 0.1 * order + 0.1) << name << ", spins: " << spins;
    }
  }
}

TEST(MotorReference, IntegratorsThatCannotFollowMotorsRefuseThem) {
  const Bench bench = benchOf(motley(), motleyStart());
  for (const char* name : {"kahan_li8", "blanes_moan6", "strang"}) {
    try {
      bench.simulation(name, 0.01);
      ADD_FAILURE() << name;
    } catch (const std::invalid_argument& refused) {
      EXPECT_EQ(std::string(refused.what()),
                "integrator must be auto or support wheels and rotors with inertia, as body 'body' "
                "needs (rk4, dop853, taylor), got '" +
                    std::string(name) + "'");
    }
  }
}

TEST(MotorReference, IntegratorsAreOfferedThatSupportAllThatTheWorldNeeds) {
  Bench bench = benchOf(motley(), motleyStart());
  bench.addSpring({kWorld, {0, 0, 3}}, {0, {0.1, 0, 0}}, {1, 0.1, 1});
  try {
    bench.simulation("strang", 0.01);
    ADD_FAILURE();
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string(refused.what()).find("needs (rk4, dop853), got 'strang'"),
              std::string::npos)
        << refused.what();
  }
}

// A body with motors that has to be integrated, here for a spring, takes their lag as a function of
// time at every stage.
TEST(MotorReference, MotorsActOnABodyOnASpring) {
  Bench bench = benchOf(motley(), motleyStart());
  bench.world.commands = {commandOf(0, 8, 0.01), commandOf(1, 40, 0.5), commandOf(2, 0.3, 0.2)};
  const State solved = bench.run("auto", 1, 100);
  bench.addSpring({kWorld, {0, 0, 3}}, {0, {0.1, 0, 0}}, {1e-9, 0, 1});
  bench.world.solver.tolerance = 1e-10;
  const State held = bench.run("auto", 1, 100);
  EXPECT_LE(angleBetween(solved.bodies[0].q_WP, held.bodies[0].q_WP), 3e-9);
  EXPECT_LE(distanceBetween(solved.bodies[0], held.bodies[0]), 3e-9);
  EXPECT_LE((solved.bodies[0].L_W - held.bodies[0].L_W).norm(), 1e-8);
}

}  // namespace rigid_body_sim
