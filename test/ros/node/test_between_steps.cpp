#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>

#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/Input.h>

#include "node_driver.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kLongStep = 0.5;  // [s] of the scene
constexpr int kPerStep = 50;       // messages: 100 a second
constexpr double kPush = 0.1;      // [s] of 1 N on 1 kg

struct Received {
  nav_msgs::Odometry message;
  ros::WallTime at;
};

class BetweenSteps : public ::testing::Test {
 protected:
  BetweenSteps() {
    const boost::function<void(const nav_msgs::Odometry&)> receive =
        [this](const nav_msgs::Odometry& m) {
          odometry.push_back({m, ros::WallTime::now()});
        };
    const boost::function<void(const Input&)> receive_input = [this](const Input& m) {
      inputs.push_back(m);
    };
    subscribers.push_back(nh.subscribe<nav_msgs::Odometry>("ball/odom", 100000, receive));
    subscribers.push_back(nh.subscribe<Input>("rigid_body_node/inputs", 100000, receive_input));
  }

  bool waitForMore(std::size_t messages) {
    const std::size_t before = odometry.size();
    return NodeDriver::waitFor([&] { return odometry.size() >= before + messages; });
  }

  void push() {
    ApplyWrench call;
    call.request.wrench.header.frame_id = "world";
    call.request.wrench.body = "ball";
    call.request.wrench.wrench.force.x = 1;
    call.request.wrench.duration = ros::Duration(kPush);
    ASSERT_TRUE(ros::service::call("rigid_body_node/apply_wrench", call));
    ASSERT_TRUE(call.response.success) << call.response.message;
  }

  ros::NodeHandle nh;
  std::vector<ros::Subscriber> subscribers;
  std::vector<Received> odometry;
  std::vector<Input> inputs;
};

}  // namespace

TEST_F(BetweenSteps, OdometryComesAtItsRateAndInItsTime) {
  ASSERT_TRUE(waitForMore(4 * kPerStep));
  for (std::size_t k = 1; k < odometry.size(); ++k)
    ASSERT_EQ(odometry[k].message.header.stamp - odometry[k - 1].message.header.stamp,
              ros::Duration(0, 10000000));
  // what is published in one burst at the end of a step has no time between first and last
  for (std::size_t k = 2 * kPerStep; k < odometry.size(); ++k)
    ASSERT_GT((odometry[k].at - odometry[k - kPerStep + 5].at).toSec(), 0.2 * kLongStep);
}

TEST_F(BetweenSteps, InputActsFromTheEndOfTheStepThatIsBeingShown) {
  ASSERT_TRUE(NodeDriver::waitFor(
      [this] { return subscribers[1].getNumPublishers() > 0 && !odometry.empty(); }));
  for (int i = 0; i < 3; ++i) {
    // at some time within a step
    ASSERT_TRUE(waitForMore(kPerStep + 17));
    push();
  }
  ASSERT_TRUE(NodeDriver::waitFor([this] { return inputs.size() == 3; }));
  ASSERT_TRUE(waitForMore(3 * kPerStep));
  std::vector<ros::Time> starts;
  for (const Input& input : inputs) {
    starts.push_back(input.header.stamp);
    EXPECT_EQ(std::fmod(input.time, kLongStep), 0) << input.time;
  }
  const double v0 = odometry.front().message.twist.twist.linear.x;
  for (const Received& received : odometry) {
    double v = v0;
    for (const ros::Time& start : starts)
      v += std::clamp((received.message.header.stamp - start).toSec(), 0.0, kPush);
    // stamps are whole nanoseconds
    ASSERT_NEAR(received.message.twist.twist.linear.x, v, 2e-9) << received.message.header.stamp;
  }
}

}  // namespace rigid_body_sim
