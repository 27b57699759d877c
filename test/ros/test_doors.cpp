#include <cmath>
#include <limits>

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <rosgraph_msgs/Log.h>

#include <rigid_body_sim/AppliedWrench.h>

#include "conversions.hpp"
#include "node_driver.hpp"

namespace rigid_body_sim {
namespace {

using GeneralMessage = AppliedWrench_<std::allocator<void>>;

// Both sides run the same steps; the figures differ by what the two ways through the body frame
// round, grown over a few thousand steps of a body that turns at some 20 rad/s.
constexpr double kTolerance = 1e-9;
constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr double kTimeout = 0.5;  // [s] the node's default

/// The node beside the core, step by step. When a message takes effect is seen, not waited for:
/// the reference is stepped with and without the wrench until the node agrees with the former.
class Doors : public ::testing::Test {
 protected:
  Doors() : driver({"box", "canary"}), reference(RIGID_BODY_SIM_TEST_SCENE) {
    // the node outlives a test: it starts over, and so does the reference
    driver.connect();
    driver.reset();
    start = driver.step(0);
    general = nh.advertise<GeneralMessage>("rigid_body_node/wrench", 100);
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
    GeneralMessage message;
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

  GeneralMessage generalMessage() const {
    GeneralMessage message;
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

}  // namespace

TEST_F(Doors, EverydayDoorAgreesWithTheCoreInEveryFrame) {
  ros::Publisher everyday = nh.advertise<geometry_msgs::WrenchStamped>("box/wrench", 100);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return everyday.getNumSubscribers() > 0; }));

  everyday.publish(everydayMessage("world"));
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtCenterOfMass("w", "box", F, T, {run.time(), kTimeout});
  });
  stepBoth(10);

  // another frame is another slot: it adds
  everyday.publish(everydayMessage("box"));
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtFrame("b", "box", F, T, Isometry3d::Identity(), {run.time(), kTimeout});
  });
  stepBoth(10);

  Isometry3d X_BF = Isometry3d::Identity();
  X_BF.translation() = Vector3d(1, 0, -0.5);
  X_BF.linear() = Quaterniond(0.8, 0, 0, 0.6).toRotationMatrix();
  everyday.publish(everydayMessage("box/tip"));
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtFrame("t", "box", F, T, X_BF, {run.time(), kTimeout});
  });

  // the same frame replaces
  geometry_msgs::WrenchStamped half = everydayMessage("box/tip");
  half.wrench.force = toVector3(F / 2);
  everyday.publish(half);
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtFrame("t", "box", F / 2, T, X_BF, {run.time(), kTimeout});
  });
  // past the timeouts of all of them
  stepBoth(60);
}

TEST_F(Doors, GeneralDoorActsAtAPointFromStartToEndExactly) {
  GeneralMessage message = generalMessage();
  // far enough off to be in before it starts; no multiple of the step
  const double begin = 30.00317;
  const double duration = 0.20491;
  message.start = start + ros::Duration(begin);
  message.duration = ros::Duration(duration);
  general.publish(message);
  sendCanary();
  stepUntil("canary", [&](ReferenceRun& run) {
    pushCanary(run);
    run.pushAtPoint("tug", "box", F, T, point, {begin, duration});
  });
  ASSERT_LT(reference.time(), begin);
  stepBoth(static_cast<int>(std::lround((31 - reference.time()) / 0.01)));
}

TEST_F(Doors, GeneralDoorReplacesTheSameIdAndAddsWithoutOne) {
  GeneralMessage message = generalMessage();
  message.duration = ros::Duration(0.3);
  general.publish(message);
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtPoint("tug", "box", F, T, point, {run.time(), 0.3});
  });
  stepBoth(5);

  message.header.frame_id = "box";
  general.publish(message);
  Isometry3d X_BF = Isometry3d::Identity();
  X_BF.translation() = point;
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtFrame("tug", "box", F, T, X_BF, {run.time(), 0.3});
  });
  stepBoth(5);

  message.id = "";
  general.publish(message);
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtFrame("", "box", F, T, X_BF, {run.time(), 0.3});
  });
  stepBoth(50);
}

TEST_F(Doors, RefuseWhatBreaksARuleAndChangeNothing) {
  std::vector<std::string> warnings;
  const boost::function<void(const rosgraph_msgs::Log&)> hear = [&](const rosgraph_msgs::Log& log) {
    if (log.msg.find("wrench refused") != std::string::npos) warnings.push_back(log.msg);
  };
  const ros::Subscriber rosout = nh.subscribe<rosgraph_msgs::Log>("/rosout", 1000, hear);

  // what acts is to be left as it was
  GeneralMessage good = generalMessage();
  good.duration = ros::Duration(100);
  general.publish(good);
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtPoint("tug", "box", F, T, point, {run.time(), 100});
  });

  std::vector<GeneralMessage> bad(8, generalMessage());
  bad[0].wrench.force.x = std::numeric_limits<double>::quiet_NaN();
  bad[1].wrench.torque.z = kForEver;
  bad[2].point.y = std::numeric_limits<double>::quiet_NaN();
  bad[3].header.frame_id = "";
  bad[4].header.frame_id = "nowhere";
  bad[5].body = "nobody";
  bad[6].duration = ros::Duration(-1);
  bad[7].id = "";  // and no duration
  for (const GeneralMessage& message : bad) general.publish(message);
  sendCanary();
  stepUntil("canary", [this](ReferenceRun& run) { pushCanary(run); });
  stepBoth(100);
  // again until the subscription to the log is up
  EXPECT_TRUE(NodeDriver::waitFor([&] {
    general.publish(bad[0]);
    return !warnings.empty();
  }));

  // many are warned of once a second at most
  for (int i = 0; i < 1000; ++i) general.publish(bad[0]);
  sendCanary();
  stepUntil("canary", [this](ReferenceRun& run) { pushCanary(run); });
  stepBoth(10);
  EXPECT_LT(warnings.size(), 100U);
}

}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  ros::init(argc, argv, "test_doors");
  ::testing::InitGoogleTest(&argc, argv);
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
