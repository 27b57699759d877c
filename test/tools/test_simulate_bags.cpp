#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sys/wait.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/messages/conversions.hpp"
#include "support/mesh_texts.hpp"
#include "support/simulate_bags.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {

using test::SimulateBags;

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
            (std::map<std::string, int>{{"/box/accel", 11},
                                        {"/box/applied_wrench", 11},
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
        std::string(" --csv no_file_yet --bag ./no_file_yet"), " --csv " + path("link"),
        " --bag " + scene_file, " --wrench-bag " + bag + " --bag " + bag,
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

TEST_F(SimulateBags, FilesThatTheSceneNamesAreNotOverwritten) {
  const std::string mesh = asciiStl(triangulated(Box{{1, 1, 1}}, 0));
  const std::string urdf =
      "<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
      "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link></robot>";
  directory.written("a.stl", mesh);
  directory.written("r.urdf", urdf);
  const std::string scene_file = directory.written("files.yaml", R"(
time_step: 0.01
bodies: [{name: a, shape: {mesh: {file: a.stl}}, mass: 1}, {name: b, urdf: {file: r.urdf}}]
)");
  std::filesystem::create_hard_link(path("a.stl"), path("hard.stl"));
  for (const std::string& arguments :
       {"--csv " + path("r.urdf"), "--bag " + path("hard.stl"), "--save " + path("./a.stl")}) {
    EXPECT_EQ(simulate(scene_file + " --duration 0.1 " + arguments), 2) << said;
    EXPECT_NE(said.find(" and a file that the scene names are the same file, "), std::string::npos)
        << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
  EXPECT_EQ(content("a.stl"), mesh);
  EXPECT_EQ(content("r.urdf"), urdf);
}

TEST_F(SimulateBags, FileThatTakesNoMoreIsReportedInOneLine) {
  // as on a full disk, but for the reason: files may not pass 64 blocks
  for (const char* output : {"--csv", "--bag"}) {
    // rosbag gives nothing back of a bag that it could not close
    const std::string command =
        "export ASAN_OPTIONS=detect_leaks=0; ulimit -f 64; " RIGID_BODY_SIM_SIMULATE " " + scene() +
        " --duration 100 " + output + " " + path("large") + " >" + path("said") + " 2>&1";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1) << output;
    const std::string text = content("said");
    const std::string last = text.substr(text.rfind("simulate: "));
    EXPECT_EQ(last, "simulate: " + path("large") + ": cannot be written: File too large\n");
  }
}

}  // namespace rigid_body_sim
