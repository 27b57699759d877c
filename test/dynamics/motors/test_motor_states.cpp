#include <gtest/gtest.h>

#include "support/motor_benches.hpp"
#include "support/refusal.hpp"

/// States of actuators that a program, or an editor of a state file, has changed.
namespace rigid_body_sim {

using namespace test;

TEST(MotorStates, AreWithinWhatCommandsReach) {
  reference::MotorBody motors = motley();
  motors.actuators[0].least = 2;  // it starts from 0
  motors.actuators[1].least = -10;
  for (std::size_t k : {0, 1}) motors.actuators[k].greatest = 10;  // the propeller starts at 15
  Simulation sim = benchOf(motors, motleyStart()).simulation("auto", 0.01);
  sim.command(commandOf(0, 99, 0));
  sim.command(commandOf(1, -99, 0));
  for (int i = 0; i < 5; ++i) sim.step();
  const State before = sim.state();
  const auto refusalWith = [&](std::size_t actuator, double ActuatorState::*member, double value) {
    State changed = before;
    changed.actuators[0][actuator].*member = value;
    return test::refusalOf([&] { sim.load(changed); });
  };
  const std::string main = "body 'body': actuator 'main': ",
                    propeller = "body 'body': actuator 'propeller': ";
  EXPECT_EQ(refusalWith(0, &ActuatorState::command, 10), "");
  EXPECT_EQ(refusalWith(0, &ActuatorState::command, 11),
            main + "command must be within the limits, 2 to 10, got 11");
  EXPECT_EQ(refusalWith(0, &ActuatorState::value, -11),
            main + "value must be within what it can reach, 0 to 10, got -11");
  EXPECT_EQ(refusalWith(1, &ActuatorState::value, 16),
            propeller + "value must be within what it can reach, -10 to 15, got 16");
  EXPECT_EQ(refusalWith(1, &ActuatorState::since, 1),
            propeller + "since must not be later than the state, at t = 0.05 s, got 1");
}

}  // namespace rigid_body_sim
