#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rosgraph_msgs/Log.h>

#include <rigid_body_sim/SimStatus.h>

#include "node_beside_core.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr double kTimeout = 0.5;  // [s] the node's default

class WrenchTopics : public NodeBesideCore {};

}  // namespace

TEST_F(WrenchTopics, EverydayTopicAgreesWithTheCoreInEveryFrame) {
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

TEST_F(WrenchTopics, GeneralTopicActsAtAPointFromStartToEndExactly) {
  AppliedWrench message = generalMessage();
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

TEST_F(WrenchTopics, GeneralTopicReplacesTheSameIdAndAddsWithoutOne) {
  AppliedWrench message = generalMessage();
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

TEST_F(WrenchTopics, RefuseWhatBreaksARuleCountItAndChangeNothing) {
  SimStatus status;
  const boost::function<void(const SimStatus&)> receive_status = [&](const SimStatus& message) {
    status = message;
  };
  const ros::Subscriber counts =
      nh.subscribe<SimStatus>("rigid_body_node/status", 10, receive_status);
  ros::Publisher everyday = nh.advertise<geometry_msgs::WrenchStamped>("box/wrench", 100);
  ASSERT_TRUE(NodeDriver::waitFor(
      [&] { return everyday.getNumSubscribers() > 0 && !status.header.frame_id.empty(); }));
  const std::uint64_t refused_before = status.refused;
  std::vector<std::string> warnings;
  const boost::function<void(const rosgraph_msgs::Log&)> receive =
      [&](const rosgraph_msgs::Log& log) {
        if (log.msg.find("wrench refused") != std::string::npos) warnings.push_back(log.msg);
      };
  const ros::Subscriber rosout = nh.subscribe<rosgraph_msgs::Log>("/rosout", 1000, receive);

  // what acts is to be left as it was
  AppliedWrench good = generalMessage();
  good.duration = ros::Duration(100);
  general.publish(good);
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtPoint("tug", "box", F, T, point, {run.time(), 100});
  });

  std::vector<AppliedWrench> bad(8, generalMessage());
  bad[0].wrench.force.x = std::numeric_limits<double>::quiet_NaN();
  bad[1].wrench.torque.z = kForEver;
  bad[2].point.y = std::numeric_limits<double>::quiet_NaN();
  bad[3].header.frame_id = "";
  bad[4].header.frame_id = "nowhere";
  bad[5].body = "nobody";
  bad[6].duration = ros::Duration(-1);
  bad[7].id = "";  // and no duration
  for (const AppliedWrench& message : bad) general.publish(message);
  for (const char* frame : {"", "nowhere", "canary", "post"})
    everyday.publish(everydayMessage(frame));
  geometry_msgs::WrenchStamped not_finite = everydayMessage("box");
  not_finite.wrench.torque.x = std::numeric_limits<double>::quiet_NaN();
  everyday.publish(not_finite);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return status.refused == refused_before + 13; }))
      << status.refused - refused_before;
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
