#pragma once

#include <functional>
#include <memory>
#include <string>

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/AppliedWrench.h>

#include "node_driver.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

// Both sides run the same steps; the figures differ by what the two ways through the body frame
// round, grown over a few thousand steps of a body that turns at some 20 rad/s.
constexpr double kTolerance = 1e-9;

/// The node beside the core, step by step. When a message takes effect is seen, not waited for:
/// the reference is stepped with and without the wrench until the node agrees with the former.
class NodeBesideCore : public ::testing::Test {
 protected:
  NodeBesideCore() : driver({"box", "canary"}), reference(RIGID_BODY_SIM_TEST_SCENE) {
    // the node outlives a test: it starts over, and so does the reference
    driver.connect();
    driver.reset();
    start = driver.step(0);
    general = nh.advertise<AppliedWrench>("rigid_body_node/wrench", 100);
    EXPECT_TRUE(NodeDriver::waitFor([&] { return general.getNumSubscribers() > 0; }));
  }

  using Push = std::function<void(ReferenceRun&)>;

  /// Steps both until the wrench acts in the node, which must agree with the reference before and
  /// after. The push gets the reference at the step boundary at which the wrench came in.
  void stepUntil(const std::string& body, const Push& push) {
    for (int i = 0; i < 10000; ++i) {
      ReferenceRun pushed = reference;
      push(pushed);
      pushed.step();
      reference.step();
      driver.step(1);
      if (distance(driver.motion(body), reference.motion(body)) < kTolerance) continue;
      reference = pushed;
      expectAgreement();
      return;
    }
    FAIL() << "the wrench on " << body << " does not act";
  }

  void stepBoth(int steps) {
    for (int i = 0; i < steps; ++i) reference.step();
    driver.step(static_cast<unsigned>(steps));
    expectAgreement();
  }

  void expectAgreement() {
    for (const char* body : {"box", "canary"}) {
      EXPECT_LT(distance(driver.motion(body), reference.motion(body)), kTolerance) << body;
      const nav_msgs::Odometry& odometry = driver.odometry(body);
      const geometry_msgs::TransformStamped& transform = driver.transform(body);
      EXPECT_EQ(transform.header.stamp, odometry.header.stamp);
      EXPECT_EQ(transform.header.frame_id, odometry.header.frame_id);
      EXPECT_EQ(transform.transform.rotation, odometry.pose.pose.orientation);
      EXPECT_EQ(fromVector3(transform.transform.translation),
                fromPoint(odometry.pose.pose.position));
    }
    // the fixed body is not among them
    EXPECT_EQ(driver.transformsAtOnce(), 2U);
  }

  /// Messages on one topic arrive in order: once the canary moves, those before it are in.
  void sendCanary() {
    AppliedWrench message;
    message.header.frame_id = "world";
    message.body = "canary";
    message.id = "canary";
    message.wrench.force.x = 1;
    message.duration = ros::Duration(0, 500000000);
    general.publish(message);
  }

  void pushCanary(ReferenceRun& run) const {
    run.pushAtCenterOfMass("c", "canary", Vector3d(1, 0, 0), Vector3d::Zero(), {run.time(), 0.5});
  }

  geometry_msgs::WrenchStamped everydayMessage(const std::string& frame) const {
    geometry_msgs::WrenchStamped message;
    message.header.frame_id = frame;
    message.wrench.force = toVector3(F);
    message.wrench.torque = toVector3(T);
    return message;
  }

  AppliedWrench generalMessage() const {
    AppliedWrench message;
    message.header.frame_id = "world";
    message.body = "box";
    message.id = "tug";
    message.point = toPoint(point);
    message.wrench.force = toVector3(F);
    message.wrench.torque = toVector3(T);
    return message;
  }

  ros::NodeHandle nh;
  NodeDriver driver;
  ReferenceRun reference;
  ros::Time start;  // where the reference has its zero
  ros::Publisher general;
  const Vector3d F{8, -5, 20};
  const Vector3d T{1, 2, -1};
  const Vector3d point{0.7, -0.4, 0.2};
};

}  // namespace rigid_body_sim
