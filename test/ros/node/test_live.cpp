#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/SimStatus.h>

#include "live_node.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kTimerError = 1e-3;  // [s] wall clock of this test and steady clock of the node

}  // namespace

TEST_F(LiveNode, ChangesItsPaceWithoutALostInstantOrAJump) {
  driver.connect();
  const std::size_t first = driver.stamps().size();
  EXPECT_EQ(setFactor(0.5), "");  // paused
  const ros::Time start = now();
  ros::WallTime begin = ros::WallTime::now();
  driver.pause(false);
  EXPECT_GE(elapsedAt(start + ros::Duration(0.1), begin), 0.2 - kTimerError);

  EXPECT_EQ(setFactor(5), "");  // running
  EXPECT_LT(elapsedAt(start + ros::Duration(2), ros::WallTime::now()), 2);
  for (std::size_t i = first; i < driver.stamps().size(); ++i)
    ASSERT_NEAR((driver.stamps()[i] - driver.stamps()[i - 1]).toSec(), 0.01, 2e-9);

  EXPECT_EQ(setFactor(0), "");
  EXPECT_LT(elapsedAt(now() + ros::Duration(10), ros::WallTime::now()), 10);
  begin = ros::WallTime::now();
  EXPECT_EQ(setFactor(1), "");
  EXPECT_GE(elapsedAt(now() + ros::Duration(0.1), begin), 0.1 - kTimerError);
  driver.pause(true);
}

TEST_F(LiveNode, KeepsItsPaceWhenAskedForAnImpossibleOne) {
  EXPECT_EQ(setFactor(3), "");
  EXPECT_EQ(setFactor(-1), "factor must be a finite number >= 0, got -1");
  EXPECT_NE(setFactor(std::nan("")), "");
  EXPECT_NE(setFactor(std::numeric_limits<double>::infinity()), "");
  SimStatus status;
  const boost::function<void(const SimStatus&)> take = [&](const SimStatus& s) { status = s; };
  ros::NodeHandle nh;
  const ros::Subscriber subscriber = nh.subscribe<SimStatus>("rigid_body_node/status", 10, take);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return status.steps > 0; }));
  EXPECT_EQ(status.requested_real_time_factor, 3);
}

TEST_F(LiveNode, DoesWhatIsChosenInTheMenuOfAHandle) {
  ros::NodeHandle nh;
  std::vector<Input> inputs;
  SimStatus status;
  const boost::function<void(const Input&)> take = [&](const Input& i) { inputs.push_back(i); };
  const boost::function<void(const SimStatus&)> look = [&](const SimStatus& s) { status = s; };
  const ros::Subscriber subscribers[] = {
      nh.subscribe<Input>("rigid_body_node/inputs", 100, take),
      nh.subscribe<SimStatus>("rigid_body_node/status", 10, look)};
  menu = nh.advertise<Feedback>("rigid_body_node/push/feedback", 100);
  driver.connect();
  ASSERT_TRUE(NodeDriver::waitFor([&] { return menu.getNumSubscribers() > 0; }));
  setFactor(1);
  choose(MenuChoice::kResume);
  EXPECT_TRUE(NodeDriver::waitFor([] { return !isPaused(); }));
  for (MenuChoice choice : {MenuChoice::kFaster, MenuChoice::kSlower, MenuChoice::kSlower})
    choose(choice);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return status.requested_real_time_factor == 0.5; }));

  choose(MenuChoice::kOneStep);  // of a run that is not paused yet
  EXPECT_TRUE(NodeDriver::waitFor([] { return isPaused(); }));
  const ros::Time paused = now();
  choose(MenuChoice::kTenSteps);
  EXPECT_GE(elapsedAt(paused + ros::Duration(0.0999), ros::WallTime::now()), 0);
  EXPECT_NEAR((now() - paused).toSec(), 0.1, 2e-9);
  choose(MenuChoice::kResume);
  EXPECT_GE(elapsedAt(paused + ros::Duration(0.2), ros::WallTime::now()), 0.15);
  choose(MenuChoice::kFollow);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return driver.transformsAtOnce() == 3; }));
  EXPECT_EQ(driver.transform("followed_body").header.frame_id, "world");
  choose(MenuChoice::kStopFollowing);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return driver.transformsAtOnce() == 2; }));
  choose(MenuChoice::kPause);
  EXPECT_TRUE(NodeDriver::waitFor([] { return isPaused(); }));

  choose(MenuChoice::kClearWrenches);
  choose(MenuChoice::kReset);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return inputs.size() >= 2; }));
  EXPECT_EQ(inputs[0].kind, Input::CLEAR);
  EXPECT_EQ(inputs[1].kind, Input::RESET);
}

TEST_F(LiveNode, RefusesAChoiceInTheMenuOfNoHandle) {
  ros::NodeHandle nh;
  SimStatus status;
  const boost::function<void(const SimStatus&)> look = [&](const SimStatus& s) { status = s; };
  const ros::Subscriber subscriber = nh.subscribe<SimStatus>("rigid_body_node/status", 10, look);
  menu = nh.advertise<Feedback>("rigid_body_node/push/feedback", 100);
  ASSERT_TRUE(NodeDriver::waitFor(
      [&] { return menu.getNumSubscribers() > 0 && !status.header.frame_id.empty(); }));
  const std::uint64_t refused = status.refused;
  driver.pause(true);
  Feedback feedback;
  feedback.event_type = Feedback::MENU_SELECT;
  feedback.menu_entry_id = static_cast<std::uint32_t>(MenuChoice::kResume);
  feedback.marker_name = feedback.header.frame_id = "nobody";
  menu.publish(feedback);
  feedback.marker_name = "box";
  menu.publish(feedback);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return status.refused >= refused + 2; }));
  EXPECT_EQ(status.refused, refused + 2);
  EXPECT_TRUE(isPaused());
}

}  // namespace rigid_body_sim
