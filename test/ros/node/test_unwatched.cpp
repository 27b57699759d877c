#include <cmath>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/GetState.h>

#include "node_driver.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kStep = 0.001;  // [s] of unwatched.test

/// A node that runs in time with the wall while nobody subscribes.
class UnwatchedNode : public ::testing::Test {
 protected:
  UnwatchedNode() { EXPECT_TRUE(get_state.waitForExistence(ros::Duration(20))); }

  GetState::Response ballNow() {
    GetState state;
    state.request.body = "ball";
    state.request.frame = "world";
    EXPECT_TRUE(get_state.call(state) && state.response.success) << state.response.message;
    return state.response;
  }

  /// Until another node, which keeps time with the wall, too, has sent two states: more than 40 ms.
  void letStepsPass() {
    ros::spinOnce();  // those that have come before
    const int before = beats_;
    EXPECT_TRUE(NodeDriver::waitFor([&] { return beats_ >= before + 2; }));
  }

  ros::NodeHandle nh;
  ros::ServiceClient get_state = nh.serviceClient<GetState>("rigid_body_node/get_state");

 private:
  int beats_ = 0;
  ros::Subscriber beat_ = nh.subscribe<nav_msgs::Odometry>(
      "beat/clock/odom", 10, [this](const nav_msgs::OdometryConstPtr&) { ++beats_; });
};

}  // namespace

// It sleeps for up to 50 ms at a time, and takes the steps that are due before it answers. Of
// several tries most count: a node that gets no processor is late.
TEST_F(UnwatchedNode, AnswersAtTheStepThatTheWallHasReached) {
  int in_time = 0;
  for (int i = 0; i < 9; ++i) {
    ballNow();  // whatever has been slept over before is taken after it at the latest
    const ros::Time first = ballNow().stamp;
    const ros::WallTime begin = ros::WallTime::now();
    letStepsPass();
    const double elapsed = (ros::WallTime::now() - begin).toSec();
    in_time += (ballNow().stamp - first).toSec() >= elapsed - 2 * kStep;
  }
  EXPECT_GE(in_time, 5);
}

TEST_F(UnwatchedNode, TakesAWrenchAtTheStepThatTheWallHasReached) {
  constexpr double kForce = 3, kMass = 2;  // [N], [kg]
  letStepsPass();
  const GetState::Response before = ballNow();
  letStepsPass();
  ApplyWrench apply;
  apply.request.wrench.header.frame_id = "world";
  apply.request.wrench.body = "ball";
  apply.request.wrench.id = "push";
  apply.request.wrench.wrench.force.x = kForce;
  ASSERT_TRUE(ros::service::call("rigid_body_node/apply_wrench", apply));
  ASSERT_TRUE(apply.response.success) << apply.response.message;
  letStepsPass();
  const GetState::Response after = ballNow();
  const double pushed = (after.twist.linear.x - before.twist.linear.x) * kMass / kForce;  // [s]
  const double start = (after.stamp - before.stamp).toSec() - pushed;
  // between two steps, to the nanosecond of the stamps; not at the last instant of the outputs
  EXPECT_NEAR(start / kStep, std::round(start / kStep), 1e-5);
  EXPECT_GT(start, kStep / 2);
  EXPECT_GT(pushed, kStep / 2);
}

}  // namespace rigid_body_sim
