#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "../../examples/drone/circle_pilot.hpp"
#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

Simulation shippedRun(const std::string& name) {
  const Scene scene = loadScene(RIGID_BODY_SIM_SCENES "/" + name);
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

BodyFrameMotion motionOf(const Simulation& run) {
  return toBodyFrameMotion(run.world().bodies[0], run.body(0));
}

BodyFrameMotion runTo(double time, Simulation& run) {
  while (run.time() < time - 1e-9) run.step();
  return motionOf(run);
}

double angleTo(const Quaterniond& a, const Quaterniond& b) { return a.angularDistance(b); }

/// As examples/drone/drone_pilot does it: speeds from a state, in effect 10 ms after it.
void fly(const Pilot& pilot, const CirclePath& path, Simulation& run) {
  const BodyFrameMotion m = motionOf(run);
  const Motion now{m.x_W, m.q_WB, m.q_WB.conjugate() * m.v_W, m.q_WB.conjugate() * m.w_W};
  const std::array<double, 4> speeds = pilot.speeds(path.at(run.time()), now);
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_EQ(run.world().bodies[0].actuators[i].name, pilot.drone.rotors[i].name);
    run.command({0, i, speeds[i], run.time() + 0.01});
  }
}

}  // namespace

TEST(BuildWorld, TakesActuatorsInTheOrderOfTheirKinds) {
  const World world = buildWorld(
      parseScene(boxScene(R"(    wheels: {yaw: {axis: [0, 0, 1], inertia: 0.01, speed: 3}}
    rotors: {left: {turns: cw, thrust: 2, drag_torque: 3, inertia: 4.0e-3, time_constant: 5, speed: 6, limits: [7, 8]}}
    thrusters: {main: {position: [1, 2, 3], direction: [2, 0, 0], time_constant: 4}}
commands:
  - {body: box, actuator: yaw, value: 1.5, start: 2.5}
)"),
                 "s.yaml"));
  const std::vector<Actuator>& actuators = world.bodies[0].actuators;
  ASSERT_EQ(actuators.size(), 3U);
  EXPECT_EQ(actuators[0].name, "main");
  const Thruster& main = std::get<Thruster>(actuators[0].kind);
  EXPECT_EQ(main.position_B, Vector3d(1, 2, 3));
  EXPECT_EQ(main.direction_B, Vector3d(1, 0, 0));
  EXPECT_EQ(main.time_constant, 4);
  const Rotor& left = std::get<Rotor>(actuators[1].kind);
  EXPECT_EQ(left.turns, -1);
  EXPECT_EQ(left.thrust, 2);
  EXPECT_EQ(left.drag_torque, 3);
  EXPECT_EQ(left.inertia, 4e-3);
  EXPECT_EQ(left.time_constant, 5);
  EXPECT_EQ(left.speed, 6);
  EXPECT_EQ(actuators[1].least, 7);
  EXPECT_EQ(actuators[1].greatest, 8);
  const Wheel& yaw = std::get<Wheel>(actuators[2].kind);
  EXPECT_EQ(yaw.axis_B, Vector3d(0, 0, 1));
  EXPECT_EQ(yaw.inertia, 0.01);
  EXPECT_EQ(yaw.speed, 3);
  ASSERT_EQ(world.commands.size(), 1U);
  EXPECT_EQ(world.commands[0].actuator, 2U);
  EXPECT_EQ(world.commands[0].value, 1.5);
  EXPECT_EQ(world.commands[0].start, 2.5);
}

// Else kinetic energy could be negative.
TEST(BuildWorld, RefusesWhatSpinsWithMoreInertiaThanItsBody) {
  const std::string rotor = "left: {turns: ccw, thrust: 0, time_constant: 1, inertia: 0.2}";
  for (const std::string& actuators :
       {std::string("wheels: {yaw: {axis: [0, 0, 1], inertia: 0.2}}"), "rotors: {" + rotor + "}"}) {
    const std::string fault = boxError("    " + actuators + "\n");
    EXPECT_EQ(fault.substr(0, kAtBox.size()), kAtBox);
    EXPECT_NE(fault.find("must be positive definite without theirs"), std::string::npos) << fault;
  }
}

TEST(Quadrotor, HoversByItself) {
  Simulation run = shippedRun("quadrotor.yaml");
  const BodyFrameMotion end = runTo(10, run);
  // sqrt(m g/(4 k)) is rounded: 1e-16 of g, over 10 s
  EXPECT_LT((end.x_W - Vector3d(1.5, 0, 1)).norm(), 1e-12);
  EXPECT_LT(angleTo(end.q_WB, Quaterniond::Identity()), 1e-12);
}

TEST(Quadrotor, IsFlownAlongACircleByItsPilot) {
  Simulation run = shippedRun("quadrotor.yaml");
  const Pilot pilot;
  const CirclePath path;
  double farthest = 0;
  while (run.time() < 12) {
    fly(pilot, path, run);
    const double error = (runTo(run.time() + 0.01, run).x_W - path.at(run.time()).position).norm();
    farthest = std::max(farthest, error);
  }
  EXPECT_LT(farthest, 0.12);
  EXPECT_GT(farthest, 0.001);
  EXPECT_EQ(run.saturations(), 0);
  // it has come round: 1.2 rad/s for 9 s, and has kept its nose ahead
  EXPECT_NEAR(std::hypot(motionOf(run).x_W.x(), motionOf(run).x_W.y()), path.radius, 0.12);
  EXPECT_LT(angleTo(motionOf(run).q_WB, Quaterniond::Identity()), 0.4);
}

TEST(SlewingSatellite, TurnsByAQuarterAboutEachAxisAndStandsStill) {
  Simulation run = shippedRun("slewing_satellite.yaml");
  const auto quarter = [](const Vector3d& axis) {
    return Quaterniond(Eigen::AngleAxisd(std::acos(-1) / 2, axis));
  };
  const Quaterniond rolled = quarter(Vector3d::UnitX());
  EXPECT_LT(angleTo(runTo(21, run).q_WB, rolled), 1e-13);
  EXPECT_LT(motionOf(run).w_W.norm(), 1e-15);
  const Quaterniond pitched = rolled * quarter(Vector3d::UnitY());
  EXPECT_LT(angleTo(runTo(43, run).q_WB, pitched), 1e-13);
  EXPECT_LT(angleTo(runTo(70, run).q_WB, pitched * quarter(Vector3d::UnitZ())), 1e-13);
  EXPECT_LT(motionOf(run).w_W.norm(), 1e-15);
  EXPECT_EQ(run.body(0).L_W, Vector3d::Zero());
}

TEST(Boat, TurnsByTheDifferenceOfItsThrustersInThePlane) {
  Simulation run = shippedRun("boat.yaml");
  const BodyFrameMotion ahead = runTo(10, run);
  EXPECT_GT(ahead.v_W.x(), 1.2);
  EXPECT_LT(std::abs(ahead.x_W.y()), 1e-12);
  const BodyFrameMotion turned = runTo(20, run);
  EXPECT_GT(turned.w_W.z(), 0.5);  // starboard pushes more: it turns to port
  EXPECT_LT(std::abs(turned.x_W.z()), 1e-12);
  EXPECT_LT(runTo(40, run).v_W.dot(motionOf(run).q_WB * Vector3d::UnitX()), -1.2);  // it backs
}

}  // namespace rigid_body_sim
