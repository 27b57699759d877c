#include <limits>
#include <thread>

#include <gtest/gtest.h>
#include <visualization_msgs/MarkerArray.h>

#include <rigid_body_sim/GetState.h>
#include <rigid_body_sim/SimStatus.h>
#include <rigid_body_sim/Step.h>

#include "node_driver.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kRoundedDigits = 1e-12;  // the same steps; conversions round in the last digits
const ros::Duration kLopsidedStep(0, 10000000);

class Services : public ::testing::Test {
 protected:
  Services() : driver({"box", "canary"}), reference(RIGID_BODY_SIM_TEST_SCENE) {
    driver.pause(true);
    driver.connect();
    driver.reset();
  }

  void expectStrictlyIncreasingStamps() const {
    for (std::size_t i = 1; i < driver.stamps().size(); ++i)
      ASSERT_LT(driver.stamps()[i - 1], driver.stamps()[i]) << "message " << i;
  }

  NodeDriver driver;
  ReferenceRun reference;
};

}  // namespace

TEST_F(Services, StepAnswersWhenTheStepsAreDoneAndPublished) {
  const ros::Time before = driver.step(0);
  EXPECT_EQ(driver.step(1), before + kLopsidedStep);
  EXPECT_EQ(driver.step(250), before + kLopsidedStep * 251);
  for (int i = 0; i < 251; ++i) reference.step();
  EXPECT_LT(distance(driver.motion("box"), reference.motion("box")), kRoundedDigits);
  expectStrictlyIncreasingStamps();
}

TEST_F(Services, StepIsRefusedWhileTheSimulationRuns) {
  driver.pause(false);
  Step call;
  call.request.steps = 1;
  ASSERT_TRUE(ros::service::call("rigid_body_node/step", call));
  EXPECT_FALSE(call.response.success);
  EXPECT_NE(call.response.message, "");
}

TEST_F(Services, PauseSilencesEveryTopicUntilTheNextStep) {
  driver.pause(false);
  const std::size_t received = driver.stamps().size();
  ASSERT_TRUE(NodeDriver::waitFor([&] { return driver.stamps().size() > received + 50; }));
  driver.pause(true);
  const ros::Time paused_at = driver.step(0);
  const ros::Time next = driver.step(1);
  EXPECT_EQ(next, paused_at + kLopsidedStep);
  ASSERT_GE(driver.stamps().size(), 2U);
  EXPECT_EQ(driver.stamps().back(), next);
  EXPECT_LE(driver.stamps()[driver.stamps().size() - 2], paused_at);
  expectStrictlyIncreasingStamps();
}

TEST_F(Services, RunningPublishesAtThePublishRateWithStampsOfTheSteps) {
  driver.pause(false);
  const std::size_t first = driver.stamps().size();
  ASSERT_TRUE(NodeDriver::waitFor([&] { return driver.stamps().size() > first + 100; }));
  driver.pause(true);
  for (std::size_t i = first + 1; i < driver.stamps().size(); ++i)
    ASSERT_EQ(driver.stamps()[i] - driver.stamps()[i - 1], kLopsidedStep);
}

TEST_F(Services, ResetGoesBackToTheInitialStateWhileTimeRunsOn) {
  driver.step(123);
  const ros::Time before = driver.step(0);
  driver.reset();
  EXPECT_EQ(driver.step(1), before + kLopsidedStep);
  reference.step();
  EXPECT_LT(distance(driver.motion("box"), reference.motion("box")), kRoundedDigits);
  expectStrictlyIncreasingStamps();
}

TEST_F(Services, AStateThatAResetHasChangedIsRepeatedWithTheTimeThatStands) {
  driver.step(123);
  const ros::Time standing = driver.step(0);
  driver.reset();
  const Motion at_start = reference.motion("box");
  EXPECT_TRUE(NodeDriver::waitFor(
      [&] { return distance(driver.motion("box"), at_start) < kRoundedDigits; }));
  EXPECT_EQ(driver.odometry("box").header.stamp, standing);
  EXPECT_EQ(driver.step(1), standing + kLopsidedStep);
  expectStrictlyIncreasingStamps();
}

TEST_F(Services, MarkersAndFixedFramesReachALateSubscriber) {
  ros::NodeHandle nh;
  visualization_msgs::MarkerArray markers;
  tf2_msgs::TFMessage frames;
  const boost::function<void(const visualization_msgs::MarkerArray&)> receive_markers =
      [&](const visualization_msgs::MarkerArray& message) { markers = message; };
  const boost::function<void(const tf2_msgs::TFMessage&)> receive_frames =
      [&](const tf2_msgs::TFMessage& message) { frames = message; };
  const ros::Subscriber a =
      nh.subscribe<visualization_msgs::MarkerArray>("rigid_body_node/markers", 10, receive_markers);
  const ros::Subscriber b = nh.subscribe<tf2_msgs::TFMessage>("/tf_static", 10, receive_frames);
  ASSERT_TRUE(
      NodeDriver::waitFor([&] { return !markers.markers.empty() && !frames.transforms.empty(); }));
  EXPECT_EQ(markers.markers.size(), 3U);
  ASSERT_EQ(frames.transforms.size(), 3U);
  EXPECT_EQ(frames.transforms[0].child_frame_id, "box/tip");
  EXPECT_EQ(frames.transforms[0].header.frame_id, "box");
  EXPECT_EQ(frames.transforms[1].child_frame_id, "post");
  EXPECT_EQ(frames.transforms[1].header.frame_id, "world");
  EXPECT_EQ(frames.transforms[2].child_frame_id, "post/top");
}

// The last one: it takes as many steps as the machine can, after which times have fewer digits than
// the others compare.
TEST_F(Services, OthersAreServedWhileManyStepsAreTakenAndPauseEndsThem) {
  ros::NodeHandle nh;
  ros::Time reported;
  const boost::function<void(const SimStatus&)> note = [&](const SimStatus& status) {
    reported = status.header.stamp;
  };
  const ros::Subscriber status = nh.subscribe<SimStatus>("rigid_body_node/status", 10, note);
  Step call;
  call.request.steps = std::numeric_limits<std::uint32_t>::max();
  std::thread stepping([&] { EXPECT_TRUE(ros::service::call("rigid_body_node/step", call)); });
  GetState before, after;
  before.request.body = before.request.frame = after.request.body = after.request.frame = "box";
  // roscpp looks services up at the master, where the two threads may meet
  const auto getState = [](GetState& state) {
    return ros::service::call("rigid_body_node/get_state", state);
  };
  EXPECT_TRUE(NodeDriver::waitFor([&] { return getState(before); }));
  EXPECT_TRUE(NodeDriver::waitFor([&] {
    return getState(after) && after.response.stamp > before.response.stamp &&
           reported > before.response.stamp;
  }));
  driver.pause(false);
  stepping.join();
  driver.pause(true);
  EXPECT_FALSE(call.response.success);
  EXPECT_NE(call.response.message.find("not paused"), std::string::npos) << call.response.message;
  EXPECT_NE(call.response.message.find(" of 4294967295 steps were taken"), std::string::npos);
  driver.reset();
}

}  // namespace rigid_body_sim
