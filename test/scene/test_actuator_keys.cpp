#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

/// The scene of one box with actuators; those of the text follow from line 6.
Scene withActuators(const std::string& text) { return parseScene(boxScene(text), "s.yaml"); }

std::string thrusterText(const std::string& keys) {
  return "    thrusters: {main: {" + keys + "}}\n";
}

std::string rotorText(const std::string& keys) { return "    rotors: {left: {" + keys + "}}\n"; }

std::string wheelText(const std::string& keys) { return "    wheels: {roll: {" + keys + "}}\n"; }

ThrusterDef thrusterOf(const std::string& keys) {
  return withActuators(thrusterText(keys)).bodies[0].actuators.thrusters[0];
}

RotorDef rotorOf(const std::string& keys) {
  return withActuators(rotorText(keys)).bodies[0].actuators.rotors[0];
}

WheelDef wheelOf(const std::string& keys) {
  return withActuators(wheelText(keys)).bodies[0].actuators.wheels[0];
}

/// Keys of one actuator, or of a command, and the line that refuses them.
using Refusals = std::vector<std::pair<std::string, std::string>>;

void expectRefused(std::string (*textOf)(const std::string& keys), const Refusals& refusals) {
  for (const auto& [keys, line] : refusals) EXPECT_EQ(boxError(textOf(keys)), line) << keys;
}

/// A thruster, main, on line 6, and a command on line 8.
std::string commandText(const std::string& keys) {
  return thrusterText("") + "commands:\n  - {" + keys + "}\n";
}

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
const std::string kThruster = kAtBox + "thrusters.main";
const std::string kRotor = kAtBox + "rotors.left";
const std::string kWheel = kAtBox + "wheels.roll";
const std::string kCommand = "s.yaml:8: commands[0]: ";

}  // namespace

TEST(ThrusterKeys, HaveDefaults) {
  const ThrusterDef thruster = thrusterOf("");
  EXPECT_EQ(thruster.name, "main");
  EXPECT_EQ(thruster.position, Vector3d::Zero());
  EXPECT_EQ(thruster.direction, Vector3d::UnitZ());
  EXPECT_EQ(thruster.limits.lowest, -kUnbounded);
  EXPECT_EQ(thruster.limits.highest, kUnbounded);
  EXPECT_EQ(thruster.time_constant, 0);
}

TEST(ThrusterKeys, AreRead) {
  const ThrusterDef thruster = thrusterOf(
      "position: [0, 0, -0.2], direction: [0, 3, 4], limits: [-1, .inf], time_constant: 0.02");
  EXPECT_EQ(thruster.position, Vector3d(0, 0, -0.2));
  EXPECT_NEAR((thruster.direction - Vector3d(0, 0.6, 0.8)).norm(), 0, 1e-16);
  EXPECT_EQ(thruster.limits.lowest, -1);
  EXPECT_EQ(thruster.limits.highest, kUnbounded);
  EXPECT_EQ(thruster.time_constant, 0.02);
}

TEST(ThrusterKeys, AreOfAnyNonzeroLengthOfDirection) {
  EXPECT_EQ(thrusterOf("direction: [0, -1.0e-300, 0]").direction, Vector3d(0, -1, 0));
  EXPECT_EQ(thrusterOf("direction: [1.0e+300, 0, 0]").direction, Vector3d(1, 0, 0));
  EXPECT_EQ(boxError(thrusterText("direction: [0, 0, 0]")),
            kThruster + ".direction must not be zero, got [0, 0, 0]");
}

TEST(ThrusterKeys, FollowTheirRules) {
  expectRefused(
      thrusterText,
      {{"limits: [2, 1]",
        kThruster + ".limits must be [lowest, highest] [N], the lower first, got [2, 1]"},
       {"limits: 3", kThruster + ".limits must be [lowest, highest] [N], got 3"},
       {"limits: [.inf, .inf]",
        kThruster +
            ".limits must be [lowest, highest] [N], not both infinite alike, got [.inf, .inf]"},
       {"limits: [0, .nan]",
        kThruster + ".limits[1] must be a number, -.inf or .inf [N], got .nan"},
       {"time_constant: 0",
        kThruster +
            ".time_constant must be from 1e-9 to 1e9 s, or left out: then the command takes "
            "effect at once, got 0"},
       {"turns: cw", kAtBox +
                         "unknown key 'thrusters.main.turns' (known: position, direction, limits, "
                         "time_constant)"}});
}

TEST(RotorKeys, HaveDefaults) {
  const RotorDef rotor = rotorOf("turns: ccw, thrust: 8.5e-6");
  EXPECT_EQ(rotor.direction, Vector3d::UnitZ());
  EXPECT_FALSE(rotor.clockwise);
  EXPECT_EQ(rotor.thrust, 8.5e-6);
  EXPECT_EQ(rotor.drag_torque, 0);
  EXPECT_EQ(rotor.inertia, 0);
  EXPECT_EQ(rotor.time_constant, 0);
  EXPECT_EQ(rotor.speed, 0);
}

TEST(RotorKeys, AreRead) {
  const RotorDef rotor = rotorOf(
      "position: [1, 2, 3], turns: cw, thrust: 8.5e-6, drag_torque: 1.4e-7, inertia: 6.0e-5, "
      "limits: [100, 1100], time_constant: 0.03, speed: -5");
  EXPECT_EQ(rotor.name, "left");
  EXPECT_EQ(rotor.position, Vector3d(1, 2, 3));
  EXPECT_TRUE(rotor.clockwise);
  EXPECT_EQ(rotor.drag_torque, 1.4e-7);
  EXPECT_EQ(rotor.inertia, 6e-5);
  EXPECT_EQ(rotor.limits.lowest, 100);
  EXPECT_EQ(rotor.limits.highest, 1100);
  EXPECT_EQ(rotor.time_constant, 0.03);
  EXPECT_EQ(rotor.speed, -5);
}

TEST(RotorKeys, FollowTheirRules) {
  expectRefused(
      rotorText,
      {{"thrust: 1", kAtBox + "missing key 'rotors.left.turns'"},
       {"turns: left, thrust: 1",
        kRotor + ".turns must be cw or ccw, as seen against the direction, got left"},
       {"turns: cw, thrust: -1", kRotor + ".thrust must be >= 0 N s^2/rad^2, got -1"},
       {"turns: cw, thrust: 1, inertia: 1",
        kRotor + ".inertia needs time_constant: without one the speed jumps with the command, "
                 "and the body with it, got 1"},
       {"turns: cw, thrust: 1, time_constant: 1e-300",
        kRotor + ".time_constant must be from 1e-9 to 1e9 s, or left out: then the command takes "
                 "effect at once, got 1e-300"},
       {"turns: cw, thrust: 1, speed: 1",
        kRotor + ".speed needs time_constant: without one the speed is always that of the "
                 "command, got 1"}});
}

TEST(WheelKeys, AreRead) {
  const WheelDef wheel = wheelOf("axis: [2, 0, 0], inertia: 0.01, limits: [-0.2, 0.2], speed: 100");
  EXPECT_EQ(wheel.axis, Vector3d::UnitX());
  EXPECT_EQ(wheel.inertia, 0.01);
  EXPECT_EQ(wheel.limits.lowest, -0.2);
  EXPECT_EQ(wheel.limits.highest, 0.2);
  EXPECT_EQ(wheel.speed, 100);
}

TEST(WheelKeys, FollowTheirRules) {
  expectRefused(wheelText,
                {{"inertia: 1", kAtBox + "missing key 'wheels.roll.axis'"},
                 {"axis: [1, 0, 0], inertia: 0", kWheel + ".inertia must be > 0 kg m^2, got 0"}});
}

TEST(Actuators, HaveNamesThatNoOtherOfTheirBodyHas) {
  EXPECT_EQ(boxError("    thrusters: {a: {}}\n    wheels: {a: {axis: [1, 0, 0], inertia: 0.01}}\n"),
            "s.yaml:7: body 'box': wheels.a: name is taken, by the actuator on line 6");
  EXPECT_EQ(boxError("    thrusters: {a b: {}}\n").substr(0, kAtBox.size() + 16),
            kAtBox + "thrusters: 'a b'");
}

TEST(Actuators, CannotBeOnABodyThatIsFixed) {
  EXPECT_EQ(boxError("    fixed: true\n    thrusters: {a: {}}\n"),
            "s.yaml:7: body 'box': thrusters.a cannot move its body, which is fixed");
}

TEST(Actuators, AreBoundedInNumber) {
  std::string text = "    thrusters:\n";
  for (int i = 0; i <= 1000; ++i) text += "      t" + std::to_string(i) + ": {}\n";
  EXPECT_EQ(boxError(text),
            "s.yaml:6: body 'box': thrusters must hold at most 1000 thrusters, got 1001");
}

TEST(ScheduledCommands, AreRead) {
  const Scene scene = withActuators(
      "    thrusters: {main: {}}\ncommands:\n  - {body: box, actuator: main, value: 7, start: "
      "0.5}\n"
      "  - {body: box, actuator: main, value: 8}\n");
  ASSERT_EQ(scene.commands.size(), 2U);
  EXPECT_EQ(scene.commands[0].body, "box");
  EXPECT_EQ(scene.commands[0].actuator, "main");
  EXPECT_EQ(scene.commands[0].value, 7);
  EXPECT_EQ(scene.commands[0].start, 0.5);
  EXPECT_EQ(scene.commands[1].start, 0);
}

TEST(ScheduledCommands, FollowTheirRules) {
  expectRefused(
      commandText,
      {{"body: box, actuator: main", kCommand + "missing key 'value'"},
       {"body: box, actuator: main, value: .nan",
        kCommand + "value must be a finite number [N, rad/s or N m], got .nan"},
       {"body: box, actuator: main, value: 1, start: -1",
        kCommand + "start must be >= 0 s, got -1"},
       {"body: bix, actuator: main, value: 1",
        kCommand + "unknown body 'bix' (known: box); did you mean 'box'?"},
       {"body: box, actuator: mein, value: 1",
        kCommand + "unknown actuator 'mein' of body 'box' (known: main); did you mean 'main'?"}});
}

}  // namespace rigid_body_sim
