#include <gtest/gtest.h>

#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/ApplyWrenches.h>
#include <rigid_body_sim/ClearWrenches.h>
#include <rigid_body_sim/StateFile.h>

#include "node_beside_core.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kLong = 100;  // [s] beyond the end of every test

/// The fault; empty when taken.
std::string faultOf(const AppliedWrench& wrench, const std::string& node = "rigid_body_node") {
  ApplyWrench call;
  call.request.wrench = wrench;
  if (!ros::service::waitForService(node + "/apply_wrench", 20000)) return "no service";
  if (!ros::service::call(node + "/apply_wrench", call)) return "no answer";
  EXPECT_EQ(call.response.success, call.response.message.empty());
  return call.response.message;
}

ClearWrenches::Response clear(const std::string& body, const std::string& id) {
  ClearWrenches call;
  call.request.body = body;
  call.request.id = id;
  EXPECT_TRUE(ros::service::call("rigid_body_node/clear_wrenches", call));
  return call.response;
}

class WrenchServices : public NodeBesideCore {
 protected:
  AppliedWrench lasting(const std::string& body, const std::string& id) const {
    AppliedWrench message = generalMessage();
    message.body = body;
    message.id = id;
    message.duration = ros::Duration(kLong);
    return message;
  }

  void pushReference(const std::string& body, const std::string& id) {
    reference.pushAtPoint(id, body, F, T, point, {reference.time(), kLong});
  }
};

}  // namespace

TEST_F(WrenchServices, ApplyActsFromTheNextStepAsTheTopicDoes) {
  AppliedWrench message = generalMessage();
  message.duration = ros::Duration(0.20491);
  EXPECT_EQ(faultOf(message), "");
  reference.pushAtPoint("tug", "box", F, T, point, {reference.time(), 0.20491});
  stepBoth(10);
  // the topic's slot is the same
  message.wrench.force.x *= 2;
  general.publish(message);
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtPoint("tug", "box", Vector3d(2 * F.x(), F.y(), F.z()), T, point,
                    {run.time(), 0.20491});
  });
  stepBoth(30);
}

TEST_F(WrenchServices, ApplyNamesTheRuleThatIsBrokenAndChangesNothing) {
  EXPECT_EQ(faultOf(lasting("box", "tug")), "");
  pushReference("box", "tug");
  AppliedWrench message = lasting("box", "tug");
  message.header.frame_id = "nowhere";
  EXPECT_NE(faultOf(message).find("unknown frame 'nowhere'"), std::string::npos);
  message = lasting("nobody", "tug");
  EXPECT_NE(faultOf(message).find("unknown body 'nobody'"), std::string::npos);
  message = lasting("box", "tug");
  message.duration = ros::Duration(-1);
  EXPECT_NE(faultOf(message).find("duration must be >= 0 s, got -1"), std::string::npos);
  stepBoth(20);
}

TEST_F(WrenchServices, ApplyRefusesWhatTheIntegratorDoesNotTake) {
  AppliedWrench message = lasting("ball", "tug");
  message.header.frame_id = "other";
  EXPECT_NE(faultOf(message, "alone/alone").find("integrator must be"), std::string::npos);
  message.header.frame_id = "ball";
  EXPECT_EQ(faultOf(message, "alone/alone"), "");
}

TEST_F(WrenchServices, ApplyRefusesWhatWouldFillTheMemory) {
  AppliedWrench message = lasting("canary", "");
  message.start = start + ros::Duration(1000);
  ros::ServiceClient client = nh.serviceClient<ApplyWrench>("rigid_body_node/apply_wrench", true);
  ApplyWrench call;
  call.request.wrench = message;
  int taken = 0;
  while (taken <= 1000 && client.call(call) && call.response.success) ++taken;
  EXPECT_EQ(taken, 1000);
  EXPECT_NE(call.response.message.find("fewer than 1000 wrenches"), std::string::npos)
      << call.response.message;
  EXPECT_EQ(clear("canary", "").message, "ended: 1000");
  EXPECT_EQ(faultOf(lasting("box", "tug")), "");
  pushReference("box", "tug");
  stepBoth(20);
}

TEST_F(WrenchServices, ApplyTakesAListWholeOrNotAtAll) {
  ApplyWrenches call;
  call.request.wrenches = {lasting("box", "tug"), lasting("nobody", "tug")};
  ASSERT_TRUE(ros::service::call("rigid_body_node/apply_wrenches", call));
  EXPECT_EQ(call.response.message.find("wrenches[1]: unknown body 'nobody'"), 0U)
      << call.response.message;
  stepBoth(5);
  call.request.wrenches[1] = lasting("canary", "tug");
  ASSERT_TRUE(ros::service::call("rigid_body_node/apply_wrenches", call));
  EXPECT_TRUE(call.response.success);
  pushReference("box", "tug");
  pushReference("canary", "tug");
  stepBoth(20);
  call.request.wrenches = {lasting("ball", "tug"), lasting("ball", "tug")};
  call.request.wrenches[1].header.frame_id = "other";
  ASSERT_TRUE(ros::service::call("alone/alone/apply_wrenches", call));
  EXPECT_EQ(call.response.message.find("wrenches[1]: integrator must be"), 0U)
      << call.response.message;
  // each replaces the one before: they are one
  call.request.wrenches.assign(1100, lasting("box", "tug"));
  ASSERT_TRUE(ros::service::call("rigid_body_node/apply_wrenches", call));
  EXPECT_TRUE(call.response.success) << call.response.message;
  for (std::size_t i = 0; i < 1100; ++i) call.request.wrenches[i].id = std::to_string(i);
  ASSERT_TRUE(ros::service::call("rigid_body_node/apply_wrenches", call));
  EXPECT_EQ(call.response.message.find("wrenches[999]: body 'box' must have fewer than"), 0U)
      << call.response.message;
}

TEST_F(WrenchServices, GoOnFromASavedStateToTheSameBits) {
  const TemporaryDirectory directory;
  const auto answer = [](const char* service, const std::string& path) {
    StateFile call;
    call.request.path = path;
    EXPECT_TRUE(ros::service::call(std::string("rigid_body_node/") + service, call));
    EXPECT_EQ(call.response.success,
              call.response.message.find(" the state at ") != std::string::npos);
    return call.response.message;
  };
  AppliedWrench message = lasting("box", "tug");
  message.start = driver.step(7) + ros::Duration(0.1234);
  EXPECT_EQ(faultOf(message), "");
  EXPECT_EQ(answer("save", directory.path("x")).find(directory.path("x: the state at ")), 0U);
  const ros::Time end = driver.step(300);
  const nav_msgs::Odometry odometry = driver.odometry("box");
  EXPECT_NE(answer("load", directory.path("x")).find(": on from the state at "), std::string::npos);
  EXPECT_GT(driver.step(300), end);
  EXPECT_EQ(driver.odometry("box").pose, odometry.pose);
  EXPECT_EQ(driver.odometry("box").twist, odometry.twist);
  EXPECT_NE(answer("load", directory.path("none")).find("cannot be opened"), std::string::npos);
  EXPECT_NE(answer("save", directory.path("none/x")).find("cannot be written"), std::string::npos);
}

TEST_F(WrenchServices, ClearEndsOneIdNowAndToCome) {
  EXPECT_EQ(faultOf(lasting("box", "a")), "");
  EXPECT_EQ(faultOf(lasting("box", "b")), "");
  EXPECT_EQ(faultOf(lasting("canary", "a")), "");
  AppliedWrench later = lasting("box", "a");
  later.start = start + ros::Duration(0.1);
  EXPECT_EQ(faultOf(later), "");
  EXPECT_TRUE(clear("box", "a").success);
  pushReference("box", "b");
  pushReference("canary", "a");
  stepBoth(20);
}

TEST_F(WrenchServices, ClearOfABodyEndsWhateverAppliedIt) {
  ros::Publisher everyday = nh.advertise<geometry_msgs::WrenchStamped>("box/wrench", 100);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return everyday.getNumSubscribers() > 0; }));
  everyday.publish(everydayMessage("world"));
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtCenterOfMass("w", "box", F, T, {run.time(), 0.5});
  });
  EXPECT_EQ(faultOf(lasting("box", "tug")), "");
  EXPECT_EQ(faultOf(lasting("canary", "tug")), "");
  EXPECT_EQ(clear("box", "").message, "ended: 2");
  reference.clear("box");
  pushReference("canary", "tug");
  stepBoth(20);
}

TEST_F(WrenchServices, ClearOfNothingNamedEndsAll) {
  EXPECT_EQ(faultOf(lasting("box", "a")), "");
  EXPECT_EQ(faultOf(lasting("canary", "a")), "");
  EXPECT_EQ(faultOf(lasting("canary", "b")), "");
  EXPECT_EQ(clear("", "a").message, "ended: 2");
  EXPECT_EQ(clear("", "").message, "ended: 1");
  stepBoth(20);
}

TEST_F(WrenchServices, ClearRefusesAnUnknownBody) {
  EXPECT_FALSE(clear("nobody", "").success);
  EXPECT_EQ(clear("nobody", "").message, "unknown body 'nobody' (known: box, canary, post)");
}

TEST_F(WrenchServices, EverydayTopicTakesAFrameThatTfHangsOnTheBody) {
  Isometry3d X_BF = Isometry3d::Identity();
  X_BF.translation() = Vector3d(0.2, -0.3, 0.4);
  X_BF.linear() = Quaterniond(0.5, 0.5, -0.5, 0.5).toRotationMatrix();
  tf2_msgs::TFMessage frames;
  for (const char* name : {"nozzle", "fin"})
    frames.transforms.push_back(toTransform(X_BF, "box", name, start));
  const ros::Publisher tf_static = nh.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  tf_static.publish(frames);
  ros::Publisher everyday = nh.advertise<geometry_msgs::WrenchStamped>("box/wrench", 100);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return everyday.getNumSubscribers() > 0; }));

  // both frames are in once a wrench of nothing is taken in one of them
  AppliedWrench probe;
  probe.header.frame_id = "nozzle";
  probe.body = "box";
  probe.duration = ros::Duration(0.001);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return faultOf(probe).empty(); }));
  everyday.publish(everydayMessage("fin"));
  stepUntil("box", [&](ReferenceRun& run) {
    run.pushAtFrame("f", "box", F, T, X_BF, {run.time(), 0.5});
  });
  stepBoth(20);
}

}  // namespace rigid_body_sim
