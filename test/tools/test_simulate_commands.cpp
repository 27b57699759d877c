#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/JointState.h>

#include "support/simulate_bags.hpp"

namespace rigid_body_sim {

using test::SimulateBags;

namespace {

const std::string kShip = R"(
time_step: 0.004
bodies:
  - name: ship
    shape: {box: [1, 2, 3]}
    mass: 2
    thrusters: {main: {position: [0.1, 0, 0], limits: [0, 20], time_constant: 0.05}}
    wheels: {yaw: {axis: [0, 0, 1], inertia: 0.01}}
)";

/// At a stamp [s] after the start.
sensor_msgs::JointState push(const ros::Time& stamp, const std::string& name, double effort) {
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  message.name = {name};
  message.effort = {effort};
  return message;
}

}  // namespace

TEST_F(SimulateBags, CommandMessagesActAtTheirStamp) {
  const ros::Time begin(1700000000, 300);
  const auto after = [&](double seconds) { return begin + ros::Duration(seconds); };
  {
    rosbag::Bag bag(path("commands.bag"), rosbag::bagmode::Write);
    bag.write("/first", begin, push(begin, "main", 1));  // no topic of a body
    bag.write("/ship/command", after(0.04), push(after(0.0511), "main", 12));
    bag.write("/ship/command", after(0.1), push(ros::Time(), "yaw", 0.5));
    bag.write("/ship/command", after(0.1), push(ros::Time(), "jaw", 0.5));
    bag.write("/ship/actuators", after(0.9), push(after(0.9), "main", 7));
  }
  const std::string of_bag = directory.written("ship.yaml", kShip);
  ASSERT_EQ(simulate(of_bag + " --sample 0.1 --csv " + path("replay.csv") + " --wrench-bag " +
                     path("commands.bag")),
            0)
      << said;
  EXPECT_NE(said.find("2 inputs taken at the times of the bag, 1 refused"), std::string::npos)
      << said;
  EXPECT_NE(said.find("changed by motors"), std::string::npos) << said;
  EXPECT_NE(said.find(": 0.9 s in steps"), std::string::npos) << said;  // as long as the record
  const std::string scheduled = directory.written("scheduled.yaml", kShip + R"(
commands:
  - {body: ship, actuator: main, value: 12, start: 0.0511}
  - {body: ship, actuator: main, value: 0, start: 0.5511}
  - {body: ship, actuator: yaw, value: 0.5, start: 0.1}
  - {body: ship, actuator: yaw, value: 0, start: 0.6}
)");
  ASSERT_EQ(simulate(scheduled + " --duration 0.9 --sample 0.1 --csv " + path("scheduled.csv")), 0)
      << said;
  EXPECT_EQ(content("replay.csv"), content("scheduled.csv"));
}

TEST_F(SimulateBags, HoldWhatActuatorsDo) {
  const std::string scene = directory.written("ship.yaml", kShip + R"(
commands: [{body: ship, actuator: yaw, value: 0.5, start: 0.105}]
)");
  ASSERT_EQ(simulate(scene + " --duration 0.2 --sample 0.1 --bag " + path("run.bag")), 0) << said;
  std::vector<double> torques;
  rosbag::Bag bag(path("run.bag"), rosbag::bagmode::Read);
  for (const rosbag::MessageInstance& message :
       rosbag::View(bag, rosbag::TopicQuery("/ship/actuators")))
    torques.push_back(message.instantiate<sensor_msgs::JointState>()->effort.at(1));
  EXPECT_EQ(torques, (std::vector<double>{0, 0, 0.5}));
}

}  // namespace rigid_body_sim
