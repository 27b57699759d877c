#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <std_srvs/SetBool.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "message_bytes.hpp"
#include "node_driver.hpp"
#include "ros/messages/conversions.hpp"

/// Two nodes on one clock, in step with each other.
namespace rigid_body_sim {
namespace {

class OneClock : public ::testing::Test {
 protected:
  ros::Subscriber subscribe(const std::string& topic, std::vector<nav_msgs::Odometry>& received) {
    const boost::function<void(const nav_msgs::Odometry&)> note =
        [&received](const nav_msgs::Odometry& odometry) {
          // without repetitions of the standing state
          if (received.empty() || received.back().header.stamp < odometry.header.stamp)
            received.push_back(odometry);
        };
    return nh.subscribe<nav_msgs::Odometry>(topic, 100000, note);
  }

  static bool pauseFollower(bool paused) {
    std_srvs::SetBool call;
    call.request.data = paused;
    return ros::service::call("/follower/node/pause", call) && call.response.success;
  }

  ros::NodeHandle nh;
  std::vector<nav_msgs::Odometry> of_leader, of_follower;
  ros::Subscriber leader = subscribe("/leader/ship/odom", of_leader);
  ros::Subscriber follower = subscribe("/follower/ship/odom", of_follower);
};

/// The first odometry at or after a stamp.
nav_msgs::Odometry odometryAt(Simulation& sim, const ros::Time& stamp) {
  while (TimeOrigin().stamp(sim.time()) < stamp) sim.step();
  return toOdometry(sim.world().bodies[0], sim.body(0), "world", TimeOrigin().stamp(sim.time()));
}

}  // namespace

TEST_F(OneClock, BothNodesPublishTheRunOfTheSceneStepByStep) {
  const Scene scene = loadScene(RIGID_BODY_SIM_MOTORS_SCENE);
  const World world = buildWorld(scene);
  for (std::vector<nav_msgs::Odometry>* received : {&of_leader, &of_follower}) {
    ASSERT_TRUE(NodeDriver::waitFor([&] { return received->size() > 100; }));
    Simulation sim(world, initialState(scene, world));
    for (std::size_t k = 0; k < 100; ++k) {
      const nav_msgs::Odometry& odometry = (*received)[k];
      ASSERT_EQ(bytesOf(odometry), bytesOf(odometryAt(sim, odometry.header.stamp))) << k;
      const ros::Time before = k > 0 ? (*received)[k - 1].header.stamp : odometry.header.stamp;
      ASSERT_EQ(odometry.header.stamp, before + ros::Duration(k > 0 ? 0.01 : 0));
    }
  }
}

TEST_F(OneClock, NoneRunsAheadOfTheOther) {
  ASSERT_TRUE(NodeDriver::waitFor([&] { return !of_leader.empty() && !of_follower.empty(); }));
  ASSERT_TRUE(pauseFollower(true));
  const auto isAhead = [&] {
    return of_leader.back().header.stamp > of_follower.back().header.stamp + ros::Duration(0.02);
  };
  // time for a leader that does not wait to run ahead, and for messages on their way, of which
  // those of one node may come before those of the other
  NodeDriver::waitFor([] { return false; }, 0.3);
  EXPECT_FALSE(isAhead());
  const ros::Time stood = of_leader.back().header.stamp;
  ASSERT_TRUE(pauseFollower(false));
  EXPECT_TRUE(NodeDriver::waitFor(
      [&] { return of_leader.back().header.stamp > stood + ros::Duration(0.1); }));
}

}  // namespace rigid_body_sim
