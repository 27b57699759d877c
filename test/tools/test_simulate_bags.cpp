#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sys/wait.h>
#include <tf2_msgs/TFMessage.h>

#include <rigid_body_sim/AppliedWrench.h>
#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/messages/conversions.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

class SimulateBags : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return directory.path(name); }

  std::string scene(const std::string& wrenches = "") const {
    return directory.written("scene.yaml", R"(
time_step: 0.004
bodies: [{name: box, shape: {box: [1, 2, 3]}, mass: 2,
          twist: {frame: world, linear: [0, 0, 0], angular: [1, 2, 0.1]},
          points: {tip: {position: [0, 0, 1.5]}}},
         {name: post, shape: {sphere: {radius: 1}}, mass: 1, fixed: true}]
)" + wrenches);
  }

  /// Exit code of `simulate`; what it says is in `said`.
  int simulate(const std::string& arguments) {
    const std::string command =
        std::string(RIGID_BODY_SIM_SIMULATE) + " " + arguments + " >" + path("said") + " 2>&1";
    const int status = WEXITSTATUS(std::system(command.c_str()));
    said = content("said");
    return status;
  }

  std::string content(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }

  /// Writes a bag with an input of 1 N at each of the times [s], 4 ms a step, held for 0.5 s, as a
  /// node publishes them that was started at `start`.
  void record(const std::string& name, const std::vector<double>& times, ros::Time start) const {
    rosbag::Bag bag(path(name), rosbag::bagmode::Write);
    for (std::size_t i = 0; i < times.size(); ++i) {
      Input input;
      input.header.frame_id = "world";
      input.header.stamp = start + ros::Duration(times[i]);
      input.number = i;
      input.step = static_cast<std::uint64_t>(std::llround(times[i] / 0.004));
      input.time = static_cast<double>(input.step) * 0.004;
      input.body = input.point_frame = "box";
      input.wrench.force.x = 1;
      input.start = input.time;
      input.end = input.time + 0.5;
      // a recorder hears it a little later
      bag.write("/rigid_body_node/inputs", input.header.stamp + ros::Duration(0.0003), input);
    }
  }

  TemporaryDirectory directory;
  std::string said;
};

geometry_msgs::WrenchStamped push(double x) {
  geometry_msgs::WrenchStamped message;
  message.header.frame_id = "world";
  message.wrench.force.x = x;
  return message;
}

}  // namespace

TEST_F(SimulateBags, BagHoldsTheTopicsOfTheNodeAtTheirStamps) {
  ASSERT_EQ(simulate(scene() + " --duration 1 --sample 0.1 --bag " + path("run.bag")), 0) << said;
  rosbag::Bag bag(path("run.bag"), rosbag::bagmode::Read);
  std::map<std::string, int> counts;
  std::vector<ros::Time> stamps;
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    ++counts[message.getTopic()];
    if (const auto odometry = message.instantiate<nav_msgs::Odometry>()) {
      // a bag has no time zero: what bears that stamp stands at the first nanosecond
      EXPECT_EQ(message.getTime(), std::max(odometry->header.stamp, ros::TIME_MIN));
      stamps.push_back(odometry->header.stamp);
    }
  }
  EXPECT_EQ(counts,
            (std::map<std::string, int>{{"/box/applied_wrench", 11},
                                        {"/box/odom", 11},
                                        {"/clock", 101},
                                        {"/rigid_body_node/markers", 12},  // the bodies once
                                        {"/rigid_body_node/states", 11},
                                        {"/tf", 11},
                                        {"/tf_static", 1}}));
  ASSERT_EQ(stamps.size(), 11U);
  EXPECT_EQ(stamps.front(), ros::Time());
  EXPECT_EQ(stamps[1], ros::Time(0, 100000000));
  EXPECT_EQ(stamps.back(), ros::Time(1, 0));
  std::multiset<std::string> latched;
  for (const rosbag::ConnectionInfo* connection : rosbag::View(bag).getConnections())
    if (connection->header->at("latching") == "1") latched.insert(connection->topic);
  EXPECT_EQ(latched, (std::multiset<std::string>{"/rigid_body_node/markers", "/tf_static"}));
}

TEST_F(SimulateBags, OdometryInTheBagIsTheStateOfTheCore) {
  ASSERT_EQ(simulate(scene() + " --duration 1.4 --bag " + path("run.bag")), 0) << said;
  const Scene loaded = loadScene(path("scene.yaml"));
  const World world = buildWorld(loaded);
  Simulation run(world, initialState(loaded, world));
  rosbag::Bag bag(path("run.bag"), rosbag::bagmode::Read);
  int compared = 0;
  for (const rosbag::MessageInstance& message :
       rosbag::View(bag, rosbag::TopicQuery("/box/odom"))) {
    const auto odometry = message.instantiate<nav_msgs::Odometry>();
    const double t = compared / 100.0;  // instants at 100 Hz, in steps of 4 ms or between them
    while (run.time() + loaded.time_step <= t * (1 + 1e-12)) run.step();
    const State state = run.time() < t * (1 - 1e-12) ? run.sample(t) : run.state();
    EXPECT_EQ(*odometry,
              toOdometry(world.bodies[0], state.bodies[0], "world", TimeOrigin().stamp(t)));
    ++compared;
  }
  EXPECT_EQ(compared, 141);  // at 100 Hz, both ends
}

TEST_F(SimulateBags, WrenchesOfTheDoorsActFromTheStepAtTheirTimeInTheBag) {
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
      rosbag::Bag bag(path("doors.bag"), rosbag::bagmode::Write);
      bag.write("/tf_static", begin + ros::Duration(0, 1), tf2_msgs::TFMessage());
      bag.write("/box/wrench", begin + ros::Duration(0.039), push(3));
      bag.write("/robot/rigid_body_node/wrench", begin + ros::Duration(0.1), general);
      bag.write("/robot/rigid_body_node/wrench", begin + ros::Duration(0.1), refused);
      bag.write("/boxes/wrench", begin + ros::Duration(0.1), push(100));
    }
    ASSERT_EQ(simulate(scene() + " --duration 1 --sample 0.1 --csv " + path("replay.csv") +
                       " --wrench-bag " + path("doors.bag")),
              0)
        << said;
    EXPECT_NE(said.find("2 wrenches taken at the times of the bag, 1 refused"), std::string::npos)
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
  {
    rosbag::Bag bag(path("robots.bag"), rosbag::bagmode::Write);
    bag.write("/robot_a/box/wrench", ros::Time(1), push(1));
    bag.write("/robot_b/box/wrench", ros::Time(2), push(1));
  }
  {
    AppliedWrench wrench;
    wrench.body = "box";
    rosbag::Bag bag(path("nodes.bag"), rosbag::bagmode::Write);
    bag.write("/a/rigid_body_node/wrench", ros::Time(1), wrench);
    bag.write("/b/rigid_body_node/wrench", ros::Time(2), wrench);
  }
  directory.written("text.bag", "no bag");
  const std::map<std::string, std::string> refusals{
      {"--wrench-bag " + path("absent.bag"), "absent.bag: Error opening file"},
      {"--wrench-bag " + path("text.bag"), "text.bag: "},
      {"--wrench-bag " + path("empty.bag"), "empty.bag: holds no wrench for a body of the scene"},
      {"--wrench-bag " + path("two.bag"), "must hold the inputs of one node, got /a/inputs and"},
      {"--wrench-bag " + path("robots.bag"),
       "must hold the wrenches of one node, got /robot_a/box/wrench and /robot_b/box/wrench"},
      {"--wrench-bag " + path("nodes.bag"),
       "must hold the wrenches of one node, got /a/rigid_body_node/wrench and /b/"},
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
  rosbag::Bag(path("run.bag"), rosbag::bagmode::Append)
      .write("/box/odom", start + ros::Duration(23.1237), nav_msgs::Odometry());
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

TEST_F(SimulateBags, FilesStayWholeWithoutStandardStreams) {
  const std::string outputs =
      " --duration 0.1 --bag " + path("run.bag") + " --csv " + path("run.csv");
  ASSERT_EQ(simulate(scene() + outputs), 0) << said;
  const std::string csv = content("run.csv");
  for (const char* closed : {">&-", "2>&-", "<&- >&- 2>&-"}) {
    const std::string command = RIGID_BODY_SIM_SIMULATE " " + scene() + outputs + " " + closed;
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << closed;
    EXPECT_EQ(content("run.csv"), csv) << closed;
    rosbag::Bag bag(path("run.bag"), rosbag::bagmode::Read);
    EXPECT_EQ(rosbag::View(bag, rosbag::TopicQuery("/box/odom")).size(), 11U) << closed;
  }
  EXPECT_EQ(WEXITSTATUS(std::system(
                (RIGID_BODY_SIM_SIMULATE " " + scene() + " --csv - >&- 2>/dev/null").c_str())),
            1);
}

TEST_F(SimulateBags, OneFileForTwoPurposesIsRefusedAndLeftAsItIs) {
  record("run.bag", {0.1}, ros::Time(0, 1));
  const std::string bag = path("run.bag"), bag_content = content("run.bag");
  const std::string scene_file = scene(), scene_content = content("scene.yaml");
  std::filesystem::create_symlink(scene_file, path("link"));
  std::filesystem::create_hard_link(bag, path("hard.bag"));
  const std::string fresh = path("fresh"), detour = directory.path("./fresh");
  for (const std::string& arguments :
       {" --csv " + fresh + " --bag " + fresh, " --csv " + fresh + " --bag " + detour,
        " --csv " + path("link"), " --bag " + scene_file, " --wrench-bag " + bag + " --bag " + bag,
        " --wrench-bag " + bag + " --csv " + path("hard.bag"), " --csv " + path("said")}) {
    EXPECT_EQ(simulate(scene_file + arguments), 2) << arguments;
    EXPECT_NE(said.find(" are the same file, "), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
  EXPECT_EQ(content("run.bag"), bag_content);
  EXPECT_EQ(content("scene.yaml"), scene_content);
  EXPECT_FALSE(std::filesystem::exists(fresh));
  EXPECT_EQ(simulate(scene_file + " --duration 0.1 --csv /dev/null --bag " + fresh), 0) << said;
}

TEST_F(SimulateBags, FileThatTakesNoMoreIsReportedInOneLine) {
  // as on a full disk, but for the reason: files may not pass 64 blocks
  for (const char* output : {"--csv", "--bag"}) {
    const std::string command = "ulimit -f 64; trap '' XFSZ; " RIGID_BODY_SIM_SIMULATE " " +
                                scene() + " --duration 100 " + output + " " + path("large") + " >" +
                                path("said") + " 2>&1";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1) << output;
    const std::string text = content("said");
    const std::string last = text.substr(text.rfind("simulate: "));
    EXPECT_EQ(last, "simulate: " + path("large") + ": cannot be written: File too large\n");
  }
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
