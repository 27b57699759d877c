#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <rosgraph_msgs/Log.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <rigid_body_sim/AppliedWrench.h>
#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/Step.h>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "node_driver.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

const std::string kLeader = "/first/rigid_body_node/";
const std::string kFollower = "/second/rigid_body_node/";
constexpr double kFollowersStep = 0.003;  // [s] of the followers

template <class Service>
typename Service::Response call(const std::string& name, typename Service::Request request = {}) {
  typename Service::Response response;
  EXPECT_TRUE(ros::service::waitForService(name, 20000));
  EXPECT_TRUE(ros::service::call(name, request, response)) << name;
  return response;
}

ros::Time step(const std::string& node, std::uint32_t count) {
  Step::Request request;
  request.steps = count;
  const Step::Response response = call<Step>(node + "step", request);
  EXPECT_TRUE(response.success) << response.message;
  return response.stamp;
}

void pause(const std::string& node, bool data) {
  std_srvs::SetBool::Request request;
  request.data = data;
  call<std_srvs::SetBool>(node + "pause", request);
}

/// The leader paused, so that its clock stands wherever a test wants it.
class Fleet : public ::testing::Test {
 protected:
  Fleet() {
    const boost::function<void(const nav_msgs::Odometry&)> receive =
        [this](const nav_msgs::Odometry& message) { odometry.push_back(message); };
    subscriber = nh.subscribe<nav_msgs::Odometry>("/second/rotor/odom", 100000, receive);
    pause(kLeader, true);
    // until the follower is received from, and has come as near to the clock as it can
    EXPECT_TRUE(NodeDriver::waitFor([&] {
      clock = step(kLeader, 10);
      return NodeDriver::waitFor([&] { return isAtClock(); }, 0.2);
    }));
  }

  /// Whether the follower has told of the last publish tick before the clock.
  bool isAtClock() const {
    if (odometry.empty()) return false;
    const ros::Duration behind = clock - odometry.back().header.stamp;
    return behind >= ros::Duration(0) && behind < ros::Duration(0.01);
  }

  /// The follower's scene, run by the core to a stamp that counts from the start.
  nav_msgs::Odometry expectedAt(const ros::Time& stamp, const TimeOrigin& origin = {}) const {
    const Scene scene = loadScene(RIGID_BODY_SIM_FOLLOWER_SCENE);
    const World world = buildWorld(scene);
    Simulation run(world, initialState(scene, world));
    const double t = origin.simulationTime(stamp);
    while (static_cast<double>(run.steps() + 1) * kFollowersStep < t + 1e-9) run.step();
    const bool is_step = origin.stamp(run.time()) == stamp;
    const State state = is_step ? run.state() : run.sample(t);
    return toOdometry(world.bodies[0], state.bodies[0], "world", stamp);
  }

  void expectOdometryOfTheCore() {
    nav_msgs::Odometry last = odometry.back();
    last.header.seq = 0;
    EXPECT_EQ(last, expectedAt(last.header.stamp));
  }

  ros::NodeHandle nh;
  ros::Subscriber subscriber;
  std::vector<nav_msgs::Odometry> odometry;
  ros::Time clock;
};

}  // namespace

TEST_F(Fleet, FollowerGoesWithTheClockAndIsTheSameToTheLastBit) {
  for (std::uint32_t steps : {1U, 7U, 100U, 33U}) {
    clock = step(kLeader, steps);
    ASSERT_TRUE(NodeDriver::waitFor([&] { return isAtClock(); }));
    expectOdometryOfTheCore();
  }
  // and on the clock's own time
  pause(kLeader, false);
  const std::size_t received = odometry.size();
  ASSERT_TRUE(NodeDriver::waitFor([&] { return odometry.size() > received + 50; }));
  pause(kLeader, true);
  clock = step(kLeader, 1);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return isAtClock(); }));
  expectOdometryOfTheCore();
  for (std::size_t i = 1; i < odometry.size(); ++i)
    ASSERT_LT(odometry[i - 1].header.stamp, odometry[i].header.stamp);
}

TEST_F(Fleet, FollowerNeverPassesTheClock) {
  pause(kFollower, true);
  Step::Request request;
  request.steps = 1000;
  const Step::Response response = call<Step>(kFollower + "step", request);
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("would pass the clock"), std::string::npos) << response.message;
  EXPECT_LE(response.stamp, clock);
  EXPECT_GT(response.stamp + ros::Duration(kFollowersStep), clock);
  // paused it stays behind, and then catches up at once
  clock = step(kLeader, 200);
  EXPECT_EQ(step(kFollower, 0), response.stamp);
  pause(kFollower, false);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return isAtClock(); }));
  expectOdometryOfTheCore();
}

TEST_F(Fleet, FollowerStartsOverWithTheClock) {
  const ros::Time before = odometry.back().header.stamp;
  call<std_srvs::Trigger>(kLeader + "reset");
  clock = step(kLeader, 5);
  ASSERT_LT(clock, before);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return isAtClock(); }));
  expectOdometryOfTheCore();
}

TEST_F(Fleet, FollowerWithoutAStartTimeBeginsWhereItReceivesTheClock) {
  std::vector<Input> inputs;
  const boost::function<void(const Input&)> receive_input = [&](const Input& m) {
    inputs.push_back(m);
  };
  std::vector<nav_msgs::Odometry> received;
  const boost::function<void(const nav_msgs::Odometry&)> receive =
      [&](const nav_msgs::Odometry& m) { received.push_back(m); };
  const ros::Subscriber a = nh.subscribe<Input>("/late/rigid_body_node/inputs", 100, receive_input);
  const ros::Subscriber b = nh.subscribe<nav_msgs::Odometry>("/late/rotor/odom", 100000, receive);
  ApplyWrench::Request nothing;
  nothing.wrench.header.frame_id = nothing.wrench.body = "rotor";
  nothing.wrench.duration = ros::Duration(0, 1);
  ASSERT_TRUE(NodeDriver::waitFor([&] {
    call<ApplyWrench>("/late/rigid_body_node/apply_wrench", nothing);
    clock = step(kLeader, 1);
    return !inputs.empty() && !received.empty();
  }));
  // where its zero lies: on a time that the clock has shown, and that time is past
  TimeOrigin origin;
  origin.start.fromNSec(inputs.back().header.stamp.toNSec() -
                        static_cast<std::uint64_t>(std::llround(inputs.back().time * 1e9)));
  EXPECT_EQ(origin.start.toNSec() % 1000000, 0U);  // the leader's clock has 1000 Hz
  EXPECT_LE(origin.start, clock);
  const nav_msgs::Odometry expected = expectedAt(received.back().header.stamp, origin);
  // wrenches of nothing part the motion: it rounds elsewhere
  EXPECT_NEAR(received.back().pose.pose.orientation.x, expected.pose.pose.orientation.x, 1e-12);
  EXPECT_NEAR(received.back().pose.pose.position.y, expected.pose.pose.position.y, 1e-12);
}

TEST_F(Fleet, SaysThatTwoNodesPublishTheClock) {
  const std::set<std::string> both{"/first/rigid_body_node", "/second/rigid_body_node"};
  std::set<std::string> said, warned;
  const boost::function<void(const rosgraph_msgs::Log&)> receive =
      [&](const rosgraph_msgs::Log& message) {
        said.insert(message.name);
        if (message.msg.find("/clock is published by two nodes, ") == 0)
          warned.insert(message.name);
      };
  const auto are_both_in = [&](const std::set<std::string>& names) {
    return std::includes(names.begin(), names.end(), both.begin(), both.end());
  };
  const ros::Subscriber log = nh.subscribe<rosgraph_msgs::Log>("/rosout", 100, receive);
  // the warning comes once: until what both nodes say arrives, they get messages to warn of
  const ros::Publisher leader = nh.advertise<AppliedWrench>(kLeader + "wrench", 10);
  const ros::Publisher follower = nh.advertise<AppliedWrench>(kFollower + "wrench", 10);
  ASSERT_TRUE(NodeDriver::waitFor([&] {
    leader.publish(AppliedWrench());
    follower.publish(AppliedWrench());
    return are_both_in(said);
  }));
  EXPECT_TRUE(warned.empty());

  const ros::Publisher second = nh.advertise<rosgraph_msgs::Clock>("/clock", 10);
  rosgraph_msgs::Clock same;  // as the leader's: nothing jumps
  same.clock = clock;
  EXPECT_TRUE(NodeDriver::waitFor([&] {
    second.publish(same);
    return are_both_in(warned);
  }));
}

}  // namespace rigid_body_sim
