#include <csignal>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sys/wait.h>
#include <unistd.h>

#include "node_driver.hpp"

namespace rigid_body_sim {
namespace {

const std::string kScene = "scene:=" RIGID_BODY_SIM_TEST_SCENE;

/// roslaunch in a process of its own, until the end of its life.
class Launched {
 public:
  explicit Launched(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"roslaunch", "rigid_body_sim"});
    arguments.push_back("rviz:=false");
    child_ = fork();
    if (child_ != 0) return;
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    execvp(argv[0], argv.data());
    _exit(127);
  }
  ~Launched() {
    kill(child_, SIGINT);
    waitpid(child_, nullptr, 0);
  }
  Launched(const Launched&) = delete;
  Launched& operator=(const Launched&) = delete;

 private:
  pid_t child_;
};

/// Whether the body that is launched says where it is, and goes on to say so.
bool movesWhenLaunched(const std::vector<std::string>& arguments) {
  ros::NodeHandle nh;
  int heard = 0;
  const boost::function<void(const nav_msgs::Odometry&)> hear = [&](const nav_msgs::Odometry&) {
    ++heard;
  };
  const ros::Subscriber subscriber = nh.subscribe<nav_msgs::Odometry>("/box/odom", 100, hear);
  const Launched launched(arguments);
  return NodeDriver::waitFor([&] { return heard > 2; });
}

}  // namespace

TEST(LaunchFiles, RunAfterOneThatSentTheSceneAsText) {
  ros::param::set("/rigid_body_node/scene", "time_step: 1");
  EXPECT_TRUE(movesWhenLaunched({"sim.launch", kScene}));
}

TEST(LaunchFiles, RunAfterOneThatNamedTheSceneFile) {
  ros::param::set("/rigid_body_node/scene_file", "/no/such/scene");
  EXPECT_TRUE(movesWhenLaunched({"remote.launch", kScene}));
}

TEST(LaunchFiles, RunInWallTimeAfterAFleet) {
  for (const char* file : {"demo.launch", "remote.launch"}) {
    SCOPED_TRACE(file);
    ros::param::set("/use_sim_time", true);
    std::vector<std::string> arguments{file};
    if (file != std::string("demo.launch")) arguments.push_back(kScene);
    EXPECT_TRUE(movesWhenLaunched(arguments));
  }
}

TEST(LaunchFiles, StartAFleetWhereItsNodesHadOtherParameters) {
  ros::param::set("/first/rigid_body_node/scene", "time_step: 1");
  ros::param::set("/second/rigid_body_node/scene", "time_step: 1");
  ros::NodeHandle nh;
  int heard = 0;
  const boost::function<void(const nav_msgs::Odometry&)> hear = [&](const nav_msgs::Odometry&) {
    ++heard;
  };
  const ros::Subscriber subscriber =
      nh.subscribe<nav_msgs::Odometry>("/second/top/odom", 100, hear);
  const Launched launched({"fleet.launch"});
  EXPECT_TRUE(NodeDriver::waitFor([&] { return heard > 2; }));
}

}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  ros::init(argc, argv, "test_launch_files");
  ::testing::InitGoogleTest(&argc, argv);
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
