#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <std_srvs/Trigger.h>

#include "node_driver.hpp"

namespace rigid_body_sim {

TEST(Clock, RunsFromZeroAtTheClockRateBesideTheOdometry) {
  ros::NodeHandle nh;
  std::vector<ros::Time> clock;
  std::vector<ros::Time> odometry;
  const boost::function<void(const rosgraph_msgs::Clock&)> receive_clock =
      [&](const rosgraph_msgs::Clock& message) { clock.push_back(message.clock); };
  const boost::function<void(const nav_msgs::Odometry&)> receive_odometry =
      [&](const nav_msgs::Odometry& message) { odometry.push_back(message.header.stamp); };
  const ros::Subscriber a = nh.subscribe<rosgraph_msgs::Clock>("/clock", 100000, receive_clock);
  const ros::Subscriber b = nh.subscribe<nav_msgs::Odometry>("box/odom", 100000, receive_odometry);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return clock.size() > 100 && odometry.size() > 100; }));
  // an hour of wall time since 1970 it is not
  EXPECT_LT(clock.front(), ros::Time(3600));
  for (std::size_t i = 1; i < clock.size(); ++i)
    ASSERT_EQ(clock[i] - clock[i - 1], ros::Duration(0, 20000000));  // 50 Hz
  for (std::size_t i = 1; i < odometry.size(); ++i)
    ASSERT_EQ(odometry[i] - odometry[i - 1], ros::Duration(0, 40000000));  // 25 Hz
}

TEST(Clock, StartsOverAtOnceWithAResetOfTime) {
  ros::NodeHandle nh;
  std::vector<ros::Time> clock;
  const boost::function<void(const rosgraph_msgs::Clock&)> receive =
      [&](const rosgraph_msgs::Clock& message) { clock.push_back(message.clock); };
  const ros::Subscriber subscriber = nh.subscribe<rosgraph_msgs::Clock>("/clock", 100000, receive);
  const ros::Time late(6);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return !clock.empty() && clock.back() > late; }));
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("rigid_body_node/reset", reset));
  clock.clear();
  ASSERT_TRUE(NodeDriver::waitFor([&] { return clock.size() > 10 && clock.back() < late; }));
  // a clock that has once gone back runs from its first tick
  const auto first = std::min_element(clock.begin(), clock.end());
  EXPECT_EQ(*first, ros::Time());
  EXPECT_TRUE(std::is_sorted(first, clock.end()));
}

}  // namespace rigid_body_sim
