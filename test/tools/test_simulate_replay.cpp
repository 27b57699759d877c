#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <rigid_body_sim/AppliedWrench.h>
#include <rigid_body_sim/Input.h>

#include "support/simulate_bags.hpp"

namespace rigid_body_sim {

using test::SimulateBags;

namespace {

geometry_msgs::WrenchStamped push(double x) {
  geometry_msgs::WrenchStamped message;
  message.header.frame_id = "world";
  message.wrench.force.x = x;
  return message;
}

}  // namespace

TEST_F(SimulateBags, WrenchMessagesActFromTheStepAtTheirTimeInTheBag) {
  AppliedWrench general;
  general.header.frame_id = "box/tip";
  general.body = "box";
  general.id = "g";
  general.wrench.torque.z = 0.5;
  general.duration = ros::Duration(0.0431);
  AppliedWrench refused = general;
  refused.body = "nobody";
  // under a clock from zero, and under a wall clock, from the beginning of the bag
  for (const ros::Time& begin : {ros::Time(), ros::Time(1700000000, 300)}) {
    {
      rosbag::Bag bag(path("messages.bag"), rosbag::bagmode::Write);
      bag.write("/tf_static", begin + ros::Duration(0, 1), tf2_msgs::TFMessage());
      bag.write("/robot/box/wrench", begin + ros::Duration(0.039), push(3));
      bag.write("/robot/rigid_body_node/wrench", begin + ros::Duration(0.1), general);
      bag.write("/robot/rigid_body_node/wrench", begin + ros::Duration(0.1), refused);
      bag.write("/robot/boxes/wrench", begin + ros::Duration(0.1), push(100));
    }
    ASSERT_EQ(simulate(scene() + " --duration 1 --sample 0.1 --csv " + path("replay.csv") +
                       " --wrench-bag " + path("messages.bag")),
              0)
        << said;
    EXPECT_NE(said.find("2 inputs taken at the times of the bag, 1 refused"), std::string::npos)
        << said;
    ASSERT_EQ(simulate(scene(R"(
wrenches: [{body: box, frame: world, force: [3, 0, 0], start: 0.04, duration: 0.5},
           {body: box, frame: box/tip, torque: [0, 0, 0.5], start: 0.1, duration: 0.0431}]
)") + " --duration 1 --sample 0.1 --csv " +
                       path("scheduled.csv")),
              0)
        << said;
    EXPECT_EQ(content("replay.csv"), content("scheduled.csv"));
  }
}

TEST_F(SimulateBags, BagThatCannotBeUsedIsRefusedInOneLine) {
  { rosbag::Bag(path("empty.bag"), rosbag::bagmode::Write); }
  {
    rosbag::Bag bag(path("two.bag"), rosbag::bagmode::Write);
    bag.write("/a/inputs", ros::Time(1), Input());
    bag.write("/b/inputs", ros::Time(1), Input());
  }
  {
    rosbag::Bag bag(path("late.bag"), rosbag::bagmode::Write);
    bag.write("/box/wrench", ros::Time(900000000), push(1));
  }
  directory.written("text.bag", "no bag");
  const std::map<std::string, std::string> refusals{
      {"--wrench-bag " + path("absent.bag"),
       "absent.bag: cannot be opened: No such file or directory"},
      {"--wrench-bag " + path("text.bag"),
       "simulate: --wrench-bag " + path("text.bag") +
           ": is not a bag: its first line must begin with #ROSBAG\n"},
      {"--wrench-bag " + path("empty.bag"),
       "empty.bag: holds no wrench and no command for a body of the scene"},
      {"--wrench-bag " + path("two.bag"), "must hold the inputs of one node, got /a/inputs and"},
      {"--time-step 1e-12 --duration 1e-9 --wrench-bag " + path("late.bag"),
       "late.bag: holds a message at more than 2^53 steps of the scene"},
      {"--bag " + path("no/such/directory"),
       "no/such/directory: cannot be written: No such file or directory"},
      {"--duration 100 --bag /dev/full", "/dev/full: cannot be written: No space left on device"}};
  for (const auto& [arguments, line] : refusals) {
    EXPECT_EQ(simulate(scene() + " " + arguments), 1) << arguments;
    EXPECT_NE(said.find(line), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

TEST_F(SimulateBags, BagWithTheInputsOfTwoNodesIsRefused) {
  AppliedWrench wrench;
  wrench.header.frame_id = "world";
  wrench.body = "box";
  const auto fault_of = [&](const std::string& of_node, const std::string& of_body) {
    {
      rosbag::Bag bag(path("pair.bag"), rosbag::bagmode::Write);
      bag.write(of_node, ros::Time(1), wrench);
      bag.write(of_body, ros::Time(2), push(1));
    }
    const int status = simulate(scene() + " --duration 0.1 --wrench-bag " + path("pair.bag"));
    return status == 1 ? said : std::to_string(status);
  };
  EXPECT_EQ(fault_of("/robot_a/rigid_body_node/wrench", "/robot_b/box/wrench"),
            "simulate: --wrench-bag " + path("pair.bag") +
                ": must hold the inputs of one node, got /robot_a/rigid_body_node/wrench and "
                "/robot_b/box/wrench; rosbag filter separates them\n");
  EXPECT_EQ(fault_of("/robot_a/rigid_body_node/wrench", "/robot_a/box/wrench"), "0") << said;
}

TEST_F(SimulateBags, SummaryNamesTheRecordedWrenchesThatChangedABody) {
  record("run.bag", {0.1}, ros::Time(0, 1));
  ASSERT_EQ(simulate(scene() + " --duration 1 --wrench-bag " + path("run.bag")), 0) << said;
  // 1 N for 0.5 s
  EXPECT_NE(said.find("  changed by wrenches: energy +0.0625 J, momentum (0.5, "),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("conserved"), std::string::npos) << said;
  ASSERT_EQ(simulate(scene() + " --duration 0.1 --wrench-bag " + path("run.bag")), 0) << said;
  EXPECT_NE(said.find("  conserved: energy "), std::string::npos) << said;
}

TEST_F(SimulateBags, InputsThatARunDoesNotReachAreReported) {
  record("run.bag", {0.1, 0.4, 0.8}, ros::Time(0, 1));
  ASSERT_EQ(simulate(scene() + " --duration 0.4 --wrench-bag " + path("run.bag")), 0) << said;
  EXPECT_NE(said.find("simulate: notice: " + path("run.bag") +
                      ": 2 of 3 inputs were not applied: they come at or after 0.4 s, where this "
                      "run ends (--duration)\n"),
            std::string::npos)
      << said;
  ASSERT_EQ(simulate(scene() + " --duration 0.9 --wrench-bag " + path("run.bag")), 0) << said;
  EXPECT_EQ(said.find("were not applied"), std::string::npos) << said;
}

TEST_F(SimulateBags, ReplayIsAsLongAsTheRecord) {
  const ros::Time start(1700000000, 300);
  const auto runs_for = [&](const std::string& seconds) {
    EXPECT_EQ(simulate(scene() + " --wrench-bag " + path("run.bag")), 0) << said;
    EXPECT_NE(said.find("scene.yaml: " + seconds + " s in steps of"), std::string::npos) << said;
    EXPECT_EQ(said.find("were not applied"), std::string::npos) << said;
  };
  record("run.bag", {0.1}, start);
  runs_for("10");  // inputs alone: the horizon
  record("run.bag", {0.1, 11.6}, start);
  runs_for("12.1");  // or as long as the last wrench acts
  record("run.bag", {0.1, 11.6}, start, 0.4);
  runs_for("12.1");
  record("run.bag", {0.1, 11.6}, start, 0.5);
  runs_for("12.1");
  nav_msgs::Odometry odometry;
  odometry.header.stamp = start + ros::Duration(23.1237);
  // a minute of wall time went by while the run was paused
  rosbag::Bag(path("run.bag"), rosbag::bagmode::Append)
      .write("/box/odom", odometry.header.stamp + ros::Duration(60), odometry);
  runs_for("23.12");  // whole steps
}

TEST_F(SimulateBags, ReplayIsStampedAsTheRecordedRun) {
  const ros::Time start(1700000000, 300);
  record("run.bag", {0.1}, start);
  ASSERT_EQ(simulate(scene() + " --duration 0.2 --sample 0.1 --wrench-bag " + path("run.bag") +
                     " --bag " + path("again.bag")),
            0)
      << said;
  rosbag::Bag bag(path("again.bag"), rosbag::bagmode::Read);
  std::vector<ros::Time> stamps;
  for (const rosbag::MessageInstance& message : rosbag::View(bag, rosbag::TopicQuery("/box/odom")))
    stamps.push_back(message.instantiate<nav_msgs::Odometry>()->header.stamp);
  EXPECT_EQ(stamps, (std::vector<ros::Time>{start, start + ros::Duration(0, 100000000),
                                            start + ros::Duration(0, 200000000)}));
}

TEST_F(SimulateBags, SaysThatTheLengthOfARunAfterAResetIsNotKnown) {
  {
    rosbag::Bag bag(path("later.bag"), rosbag::bagmode::Write);
    Input clear;  // of the first step, in order
    clear.kind = Input::CLEAR;
    bag.write("/rigid_body_node/inputs", ros::Time(1), clear);
    clear.run = 1;
    bag.write("/rigid_body_node/inputs", ros::Time(2), clear);
  }
  const std::string notice = "later.bag: holds several runs, separated by resets or loads, ";
  ASSERT_EQ(simulate(scene() + " --wrench-bag " + path("later.bag")), 0) << said;
  EXPECT_NE(said.find(notice), std::string::npos) << said;
  ASSERT_EQ(simulate(scene() + " --duration 0.1 --wrench-bag " + path("later.bag")), 0) << said;
  EXPECT_EQ(said.find(notice), std::string::npos) << said;
}

TEST_F(SimulateBags, InputOfAnotherSceneIsRefusedInOneLineHoweverLateItComes) {
  {
    rosbag::Bag bag(path("other.bag"), rosbag::bagmode::Write);
    Input clear;  // of the first step, in order
    clear.kind = Input::CLEAR;
    bag.write("/rigid_body_node/inputs", ros::Time(1), clear);
    Input late = clear;
    late.number = 1;
    late.step = 100;
    late.time = 0.5;  // of a step of 5 ms, where this scene has 4
    bag.write("/rigid_body_node/inputs", ros::Time(2), late);
  }
  EXPECT_EQ(simulate(scene() + " --duration 1 --wrench-bag " + path("other.bag")), 1);
  EXPECT_NE(said.find("another time_step"), std::string::npos) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

}  // namespace rigid_body_sim
