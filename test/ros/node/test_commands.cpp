#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Log.h>
#include <sensor_msgs/JointState.h>
#include <sys/wait.h>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/SimStatus.h>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "message_bytes.hpp"
#include "node_driver.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/outputs/state_messages.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

using sensor_msgs::JointState;

/// The same scene with these commands in it.
Simulation scheduled(const std::string& commands) {
  std::ostringstream text;
  text << std::ifstream(RIGID_BODY_SIM_MOTORS_SCENE).rdbuf();
  const Scene scene = parseScene(text.str() + "\ncommands:\n" + commands, "scheduled");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

JointState effort(double stamp, const std::vector<std::string>& names, std::vector<double> values) {
  JointState message;
  message.header.stamp = ros::Time(stamp);
  message.name = names;
  message.effort = std::move(values);
  return message;
}

JointState speed(double stamp, const std::string& name, double value) {
  JointState message;
  message.header.stamp = ros::Time(stamp);
  message.name = {name};
  message.velocity = {value};
  return message;
}

/// A node that stands one step after the start of time.
class Commands : public ::testing::Test {
 protected:
  Commands() {
    subscribers.push_back(nh.subscribe<Input>("rigid_body_node/inputs", 1000,
                                              [this](auto& input) { inputs.push_back(*input); }));
    subscribers.push_back(nh.subscribe<JointState>("ship/actuators", 1000, [this](auto& message) {
      actuators[message->header.stamp] = *message;
    }));
    subscribers.push_back(nh.subscribe<SimStatus>("rigid_body_node/status", 10,
                                                  [this](auto& message) { status = *message; }));
  }

  void SetUp() override {
    driver.connect();
    ASSERT_TRUE(NodeDriver::waitFor([&] {
      driver.step(1);
      return command.getNumSubscribers() > 0 && !actuators.empty() && status.steps > 0;
    }));
    driver.reset();
    driver.step(1);
    ASSERT_TRUE(NodeDriver::waitFor(
        [&] { return !inputs.empty() && inputs.back().kind == Input::RESTART; }));
    restart = inputs.back();
    inputs.clear();
    actuators.clear();
  }

  /// Until the node has taken it over.
  void send(const JointState& message) {
    const std::size_t known = inputs.size() + message.name.size();
    command.publish(message);
    ASSERT_TRUE(NodeDriver::waitFor([&] { return inputs.size() == known; }));
  }

  std::uint64_t refused() {
    const ros::Time stamp = status.header.stamp;
    const std::uint64_t steps = status.steps;
    driver.step(1);
    EXPECT_TRUE(
        NodeDriver::waitFor([&] { return status.steps > steps || status.header.stamp != stamp; }));
    return status.refused;
  }

  /// The node has come to the same bits as the run of a scene, in odometry and actuators.
  void expectAs(Simulation& run) {
    const ros::Time stamp = driver.odometry("ship").header.stamp;
    while (TimeOrigin().stamp(run.time()) < stamp) run.step();
    ASSERT_TRUE(NodeDriver::waitFor([&] { return actuators.count(stamp) > 0; }));
    const Body& body = run.world().bodies[0];
    EXPECT_EQ(bytesOf(driver.odometry("ship")),
              bytesOf(toOdometry(body, run.body(0), "world", stamp)));
    EXPECT_EQ(bytesOf(actuators[stamp]), bytesOf(toJointState(body, run.actuators(0), stamp)));
  }

  ros::NodeHandle nh;
  NodeDriver driver{{"ship"}};
  ros::Publisher command = nh.advertise<JointState>("ship/command", 100);
  std::vector<ros::Subscriber> subscribers;
  Input restart;              // with which the run begins
  std::vector<Input> inputs;  // since then
  std::map<ros::Time, JointState> actuators;
  SimStatus status;
};

}  // namespace

// time stands, and is near zero: only the clock on the wall tells when to warn again
TEST_F(Commands, AreWarnedOfWhereTimeStandsBeforeTheirStamp) {
  std::string told;
  const ros::Subscriber log = nh.subscribe<rosgraph_msgs::Log>("/rosout", 1000, [&](auto& message) {
    if (message->msg.find("command on ship/command is stamped ") == 0) told = message->msg;
  });
  // again and again: the first warning may come before the log is connected
  std::size_t sent = 0;
  EXPECT_TRUE(NodeDriver::waitFor([&] {
    command.publish(speed(5, "left", 700));
    ++sent;
    return !told.empty();
  }));
  EXPECT_TRUE(NodeDriver::waitFor([&] { return inputs.size() == sent; }));  // none on its way
  EXPECT_NE(told.find(" s ahead of simulation time: it waits until then"), std::string::npos);
}

TEST_F(Commands, TakeEffectExactlyAtTheirStampAndEndByTheTimeout) {
  send(effort(0.0512345, {"yaw", "main"}, {-1, 17}));
  send(speed(0.0698765, "left", 700));
  driver.step(10);
  Simulation run = scheduled(R"(
  - {body: ship, actuator: yaw, value: -1, start: 0.0512345}
  - {body: ship, actuator: main, value: 17, start: 0.0512345}
  - {body: ship, actuator: left, value: 700, start: 0.0698765}
  - {body: ship, actuator: yaw, value: 0, start: 0.2512345}
  - {body: ship, actuator: main, value: 1, start: 0.2512345}
  - {body: ship, actuator: left, value: 0, start: 0.2698765}
)");
  expectAs(run);
  EXPECT_EQ(actuators.rbegin()->second.effort[2], -1);
  driver.step(30);
  expectAs(run);
  EXPECT_EQ(actuators.rbegin()->second.effort[2], 0);
}

TEST_F(Commands, OfThePastTakeEffectNowAndLeaveTheOthers) {
  send(effort(0, {"yaw"}, {1.5}));
  driver.step(5);
  send(effort(0.01, {"main"}, {5}));
  driver.step(5);
  Simulation run = scheduled(R"(
  - {body: ship, actuator: yaw, value: 1.5, start: 0.01}
  - {body: ship, actuator: main, value: 5, start: 0.06}
)");
  expectAs(run);
}

TEST_F(Commands, BeyondALimitAreHeldAtItAndCounted) {
  const std::uint64_t before = status.saturations;
  send(effort(0, {"yaw"}, {5}));
  driver.step(2);
  Simulation run = scheduled("  - {body: ship, actuator: yaw, value: 2, start: 0.01}\n");
  expectAs(run);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return status.saturations != before; }));
  EXPECT_EQ(status.saturations, 1U);
}

TEST_F(Commands, ThatBreakARuleChangeNothingAndAreCounted) {
  const std::uint64_t before = refused();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<JointState> bad{effort(0, {"main", "mein"}, {5, 5}),
                              effort(0, {"yaw", "main"}, {1, nan}),
                              effort(0, {"yaw", "main"}, {1}),
                              effort(0, {"yaw", "yaw"}, {1, 1}),
                              effort(0, {"left"}, {1}),
                              effort(0, {}, {})};
  for (const JointState& message : bad) command.publish(message);
  send(effort(0.5, {"yaw"}, {1}));  // behind them
  EXPECT_EQ(inputs.size(), 1U);
  EXPECT_EQ(refused(), before + bad.size());
  Simulation run = scheduled("  - {body: ship, actuator: yaw, value: 1, start: 0.5}\n");
  expectAs(run);
}

TEST_F(Commands, AreRepeatedToTheSameBytesFromARecord) {
  for (int i = 0; i < 20; ++i) {
    const double now = 0.01 + 0.03 * i;
    send(effort(i % 3 == 0 ? 0 : now + 0.0123, {"yaw", "main"}, {std::sin(i), 30 * std::cos(i)}));
    send(speed(now + 0.05, "left", 100 * i));
    driver.step(3);
  }
  const ros::Time end = driver.step(20);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return actuators.count(end) > 0; }));
  const TemporaryDirectory files;
  const std::string recorded = files.path("recorded.bag"), repeated = files.path("repeated.bag");
  {
    rosbag::Bag bag(recorded, rosbag::bagmode::Write);
    bag.write("/rigid_body_node/inputs", ros::TIME_MIN, restart);
    for (const Input& input : inputs)
      bag.write("/rigid_body_node/inputs", input.header.stamp, input);
  }
  const std::string call = std::string(RIGID_BODY_SIM_SIMULATE) +
                           " " RIGID_BODY_SIM_MOTORS_SCENE " --wrench-bag " + recorded + " --bag " +
                           repeated + " --duration " + std::to_string(end.toSec()) + " >/dev/null";
  ASSERT_EQ(WEXITSTATUS(std::system(call.c_str())), 0) << call;
  std::size_t same = 0, all = 0;
  rosbag::Bag bag(repeated, rosbag::bagmode::Read);
  for (const rosbag::MessageInstance& message :
       rosbag::View(bag, rosbag::TopicQuery("/ship/actuators"))) {
    const JointState::ConstPtr again = message.instantiate<JointState>();
    if (!again || actuators.count(again->header.stamp) == 0) continue;
    ++all;
    same += bytesOf(*again) == bytesOf(actuators[again->header.stamp]);
  }
  EXPECT_GE(all, 70U);
  EXPECT_EQ(same, all);
}

}  // namespace rigid_body_sim
