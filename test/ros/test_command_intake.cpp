#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/command_intake.hpp"

namespace rigid_body_sim {
namespace {

/// A body with an actuator of each kind, in the order thruster, rotor, wheel.
class CommandMessages : public ::testing::Test {
 protected:
  using JointState = sensor_msgs::JointState;

  static JointState message(std::vector<std::string> names, std::vector<double> velocity,
                            std::vector<double> effort) {
    JointState m;
    m.name = std::move(names);
    m.velocity = std::move(velocity);
    m.effort = std::move(effort);
    return m;
  }

  std::vector<ActuatorCommand> take(const JointState& m, double timeout = 0.5) const {
    std::vector<ActuatorCommand> commands;
    for (const CommandInput& input : CommandIntake(world, timeout).take(1, m, origin, now))
      commands.push_back(input.command);
    return commands;
  }

  std::string fault(const JointState& m) const {
    try {
      take(m);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "";
  }

  const Scene scene = parseScene(R"(
time_step: 0.01
bodies:
  - {name: other, shape: {sphere: {radius: 1}}, mass: 1}
  - name: ship
    shape: {sphere: {radius: 1}}
    mass: 1
    thrusters: {main: {}}
    rotors: {left: {turns: cw, thrust: 1.0e-5, limits: [0, 100]}}
    wheels: {yaw: {axis: [0, 0, 1], inertia: 0.01}}
)",
                                 "test");
  const World world = buildWorld(scene);
  const TimeOrigin origin{ros::Time(1700000000, 500000000)};
  const double now = 4;
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_F(CommandMessages, AreVelocitiesOfRotorsAndEffortsOfTheOthers) {
  const auto commands = take(message({"yaw", "left", "main"}, {0, 70, 0}, {0.1, 0, -3}));
  ASSERT_EQ(commands.size(), 3U);
  const std::size_t actuators[] = {2, 1, 0};
  const double values[] = {0.1, 70, -3};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(commands[i].body, 1U);
    EXPECT_EQ(commands[i].actuator, actuators[i]);
    EXPECT_EQ(commands[i].value, values[i]);
  }
}

TEST_F(CommandMessages, BeyondALimitAreTakenForTheCoreToHoldAndCount) {
  EXPECT_EQ(take(message({"left"}, {170}, {}))[0].value, 170);
}

TEST_F(CommandMessages, TakeEffectAtTheirStampOrNowWhereItIsPastOrZero) {
  JointState m = message({"main"}, {}, {1});
  EXPECT_EQ(take(m)[0].start, now);
  m.header.stamp = ros::Time(1700000001, 0);
  EXPECT_EQ(take(m)[0].start, now);
  m.header.stamp = ros::Time(1700000005, 750000001);
  EXPECT_EQ(take(m)[0].start, 5.250000001);
}

TEST_F(CommandMessages, OfAnotherClockAreRefused) {
  JointState m = message({"main"}, {}, {1});
  m.header.stamp = ros::Time(1700000000 + 3604, 500000000);
  EXPECT_EQ(take(m)[0].start, 3604);
  m.header.stamp = ros::Time(1800000000, 500000000);
  EXPECT_EQ(
      fault(m),
      "stamp must be at most 3600 s ahead of simulation time, got 1800000000.500000000, which "
      "is 1e+08 s ahead: of another clock?");
}

TEST_F(CommandMessages, EndByTheTimeoutAfterTheirStart) {
  JointState m = message({"main"}, {}, {1});
  m.header.stamp = ros::Time(1700000005, 750000000);
  EXPECT_EQ(take(m)[0].end, 5.75);
  EXPECT_EQ(take(m, 0)[0].end, std::numeric_limits<double>::infinity());
}

TEST_F(CommandMessages, AreRefusedForNamesThatAreUnknownOrStandTwice) {
  EXPECT_EQ(fault(message({}, {}, {})), "name must hold at least one actuator, got none");
  EXPECT_EQ(
      fault(message({"mein"}, {}, {1})),
      "unknown actuator 'mein' of body 'ship' (known: main, left, yaw); did you mean 'main'?");
  EXPECT_EQ(fault(message({"yaw", "main", "yaw"}, {}, {1, 2, 3})),
            "name must hold 'yaw' once, got it twice");
}

TEST_F(CommandMessages, AreRefusedForFieldsOfAnotherLengthThanNames) {
  EXPECT_EQ(fault(message({"main", "yaw"}, {}, {1})),
            "effort must be empty or as long as name, which has 2, got 1");
  EXPECT_EQ(fault(message({"left"}, {1, 2}, {})),
            "velocity must be empty or as long as name, which has 1, got 2");
  JointState m = message({"main"}, {}, {1});
  m.position = {0};
  EXPECT_EQ(fault(m), "position must be empty: no actuator takes a position");
}

TEST_F(CommandMessages, AreRefusedInTheFieldOfAnotherKind) {
  EXPECT_EQ(fault(message({"left"}, {}, {1})),
            "velocity must hold a command for 'left', but is empty: velocity is of rotors, effort "
            "of thrusters and wheels");
  EXPECT_EQ(fault(message({"main"}, {1}, {})),
            "effort must hold a command for 'main', but is empty: velocity is of rotors, effort of "
            "thrusters and wheels");
  EXPECT_EQ(fault(message({"left", "main"}, {1, 2}, {0, 3})),
            "velocity of 'main' must be 0 or left out, as its command is its effort, got 2");
  EXPECT_EQ(fault(message({"left", "main"}, {1, 0}, {kNan, 3})),
            "effort of 'left' must be 0 or left out, as its command is its velocity, got nan");
}

TEST_F(CommandMessages, AreRefusedWhereTheyAreNotFinite) {
  EXPECT_EQ(fault(message({"main"}, {}, {kNan})), "effort of 'main' must be finite, got nan");
  EXPECT_EQ(fault(message({"left", "main"}, {HUGE_VAL, 0}, {0, 1})),
            "velocity of 'left' must be finite, got inf");
}

}  // namespace rigid_body_sim
