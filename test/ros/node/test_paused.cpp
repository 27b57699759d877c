#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <std_srvs/SetBool.h>
#include <tf2_msgs/TFMessage.h>

#include <rigid_body_sim/BodyStates.h>

#include "node_driver.hpp"

namespace rigid_body_sim {
namespace {

void pause(bool paused) {
  std_srvs::SetBool call;
  call.request.data = paused;
  ASSERT_TRUE(ros::service::call("rigid_body_node/pause", call));
}

/// A client that comes while the node is paused.
class Paused : public ::testing::Test {
 protected:
  Paused() {
    EXPECT_TRUE(ros::service::waitForService("rigid_body_node/pause", 20000));
    pause(true);
    subscribe<rosgraph_msgs::Clock>("/clock", [this](const auto& m) { clock.push_back(m.clock); });
    subscribe<nav_msgs::Odometry>("box/odom", [this](const auto& m) { odometry.push_back(m); });
    subscribe<BodyStates>("rigid_body_node/states",
                          [this](const auto& m) { states.push_back(m.header.stamp); });
    subscribe<tf2_msgs::TFMessage>("/tf", [this](const auto& m) { tf.push_back(m); });
  }

  template <class Message, class Function>
  void subscribe(const std::string& topic, Function f) {
    const boost::function<void(const Message&)> receive = f;
    subscribers.push_back(nh.subscribe<Message>(topic, 100000, receive));
  }

  ros::NodeHandle nh;
  std::vector<ros::Subscriber> subscribers;
  std::vector<ros::Time> clock, states;
  std::vector<nav_msgs::Odometry> odometry;
  std::vector<tf2_msgs::TFMessage> tf;
};

}  // namespace

TEST_F(Paused, SendsTheStandingStateToWhoComesAndTheClockAgainAndAgain) {
  ASSERT_TRUE(NodeDriver::waitFor([this] {
    return clock.size() > 10 && odometry.size() > 2 && states.size() > 2 && !tf.empty();
  }));
  for (const ros::Time& time : clock) EXPECT_EQ(time, clock[0]);
  for (const ros::Time& time : states) EXPECT_EQ(time, clock[0]);
  for (const nav_msgs::Odometry& message : odometry) EXPECT_EQ(message.header.stamp, clock[0]);
  // a repeated stamp on tf would raise a warning in every listener
  ASSERT_EQ(tf.size(), 1U);
  EXPECT_EQ(tf[0].transforms.at(0).header.stamp, clock[0]);
  EXPECT_EQ(tf[0].transforms.at(0).child_frame_id, "robot_1/box");
  EXPECT_EQ(odometry[0].child_frame_id, "robot_1/box");
  EXPECT_EQ(odometry[0].pose.covariance[35], 0.25);
  EXPECT_EQ(odometry[0].twist.covariance[0], 0.25);
}

TEST_F(Paused, GoesOnWithStampsThatStrictlyIncrease) {
  ASSERT_TRUE(NodeDriver::waitFor([this] { return !odometry.empty() && !tf.empty(); }));
  for (int i = 0; i < 5; ++i) {
    const std::size_t before = tf.size();
    pause(false);
    ASSERT_TRUE(NodeDriver::waitFor([&] { return tf.size() > before + 10; }));
    pause(true);
  }
  for (std::size_t k = 1; k < tf.size(); ++k)
    ASSERT_LT(tf[k - 1].transforms.at(0).header.stamp, tf[k].transforms.at(0).header.stamp) << k;
}

}  // namespace rigid_body_sim
