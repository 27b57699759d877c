#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sys/wait.h>
#include <unistd.h>

#include "node_driver.hpp"
#include "ros/options/node_options.hpp"
#include "support/run_command.hpp"

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

// [s] that the demo may try integrators for, under the thread sanitizer on a slow machine
constexpr double kTrials = 200;

/// Whether the body that is launched says where it is, and goes on to say so.
bool movesWhenLaunched(const std::vector<std::string>& arguments) {
  ros::NodeHandle nh;
  int received = 0;
  const boost::function<void(const nav_msgs::Odometry&)> receive = [&](const nav_msgs::Odometry&) {
    ++received;
  };
  const ros::Subscriber subscriber = nh.subscribe<nav_msgs::Odometry>("/box/odom", 100, receive);
  const Launched launched(arguments);
  return NodeDriver::waitFor([&] { return received > 2; }, kTrials);
}

/// How a launch file starts rviz.
struct RvizCommand {
  std::map<std::string, std::string> options;   ///< by their letters, such as "-d"
  std::map<std::string, std::string> remapped;  ///< names of topics
};

RvizCommand rvizCommand(const std::vector<std::string>& arguments) {
  std::string command = "roslaunch --args /rviz rigid_body_sim";
  for (const std::string& argument : arguments) command += " " + argument;
  RvizCommand rviz;
  std::istringstream words(test::runCommand(command).out);
  for (std::string word; words >> word;) {
    const std::size_t becomes = word.find(":=");
    if (becomes != std::string::npos)
      rviz.remapped[word.substr(0, becomes)] = word.substr(becomes + 2);
    else if (word[0] == '-')
      words >> rviz.options[word];
  }
  return rviz;
}

std::string resolved(const RvizCommand& rviz, const std::string& topic) {
  const auto other = rviz.remapped.find(topic);
  return ros::names::resolve("/", other == rviz.remapped.end() ? topic : other->second);
}

/// The topics that the displays of rviz subscribe to. A display of handles says in a third one, in
/// the same namespace, what the mouse does.
std::vector<std::string> shownTopics(const RvizCommand& rviz) {
  std::vector<std::string> topics;
  std::ifstream configuration(rviz.options.at("-d"));
  const std::string key = " Topic: ";
  const std::string update = "/update";
  for (std::string line; std::getline(configuration, line);) {
    const std::size_t at = line.find(key);
    if (at == std::string::npos) continue;
    const std::string topic = line.substr(at + key.size());
    topics.push_back(resolved(rviz, topic));
    const std::size_t name = topic.rfind(update);
    if (name == std::string::npos) continue;
    topics.push_back(resolved(rviz, topic + "_full"));
    const std::string space = topics.back().substr(0, topics.back().rfind('/'));
    EXPECT_EQ(resolved(rviz, topic.substr(0, name) + "/feedback"), space + "/feedback");
  }
  return topics;
}

bool isPublished(const std::string& topic) {
  ros::master::V_TopicInfo all;
  ros::master::getTopics(all);
  return std::any_of(all.begin(), all.end(),
                     [&](const ros::master::TopicInfo& info) { return info.name == topic; });
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
  int received = 0;
  const boost::function<void(const nav_msgs::Odometry&)> receive = [&](const nav_msgs::Odometry&) {
    ++received;
  };
  const ros::Subscriber subscriber =
      nh.subscribe<nav_msgs::Odometry>("/second/top/odom", 100, receive);
  const Launched launched({"fleet.launch"});
  EXPECT_TRUE(NodeDriver::waitFor([&] { return received > 2; }));
}

TEST(LaunchFiles, ShowInRvizWhatTheirNodesPublish) {
  const std::vector<std::vector<std::string>> launches{{"sim.launch", kScene},
                                                       {"demo.launch"},
                                                       {"remote.launch", kScene},
                                                       {"fleet.launch"},
                                                       {"fleet.launch", "ns:=a", "follower_ns:=b"}};
  for (const std::vector<std::string>& arguments : launches) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    const std::vector<std::string> topics = shownTopics(rvizCommand(arguments));
    // the bodies of every node, and two topics of their handles
    ASSERT_EQ(topics.size(), arguments[0] == "fleet.launch" ? 6U : 3U);
    const Launched launched(arguments);
    for (const std::string& topic : topics)
      EXPECT_TRUE(NodeDriver::waitFor([&] { return isPublished(topic); }, kTrials)) << topic;
  }
}

TEST(LaunchFiles, PassOnEveryParameterOfTheNode) {
  // by parameter: a value that is not its default, as an argument
  const std::map<std::string, std::string> values{{"body_topics", "false"},
                                                  {"clock_rate", "7"},
                                                  {"command_timeout", "0.25"},
                                                  {"lockstep", "box/wrench"},
                                                  {"lockstep_period", "0.5"},
                                                  {"lockstep_timeout", "60"},
                                                  {"odometry_covariance", "0.5"},
                                                  {"publish_clock", "true"},
                                                  {"publish_rate", "8"},
                                                  {"real_time_factor", "2"},
                                                  {"reset_time", "true"},
                                                  {"start_paused", "true"},
                                                  {"start_time", "9"},
                                                  {"tf_prefix", "robot_1"},
                                                  {"wrench_timeout", "3"}};
  const std::set<std::string> scene{"scene", "scene_file"};
  const std::set<std::string> followed{"start_time"};  // on another node's clock only
  const std::set<std::string> of_a_clock{"publish_clock", "clock_rate", "reset_time",
                                         "real_time_factor"};
  const std::vector<std::pair<std::string, std::set<std::string>>> files{
      {"sim.launch " + kScene, followed},
      {"demo.launch", followed},
      {"remote.launch " + kScene, followed},
      {"follower.launch ns:=a " + kScene, of_a_clock}};
  for (const auto& [file, left_out] : files) {
    std::string command = "roslaunch --dump-params rigid_body_sim " + file;
    std::vector<std::string> expected;
    for (const std::string& name : parameterNames()) {
      if (scene.count(name) + left_out.count(name) > 0) continue;
      ASSERT_EQ(values.count(name), 1U) << name;
      const std::string argument = name == "start_paused" ? "paused" : name;
      command += " " + argument + ":=" + values.at(name);
      expected.push_back("rigid_body_node/" + name + ": " + values.at(name) + "\n");
    }
    const std::string parameters = test::runCommand(command).out;
    for (const std::string& line : expected)
      EXPECT_NE(parameters.find(line), std::string::npos) << file << ": " << line << parameters;
  }
}

// roslaunch lists arguments whose default is empty as required, and prints blanks as they are.
TEST(LaunchFiles, SayWhichArgumentsAreOptionalInOneLineEach) {
  std::istringstream lines(test::runCommand("roslaunch --ros-args rigid_body_sim sim.launch").out);
  std::vector<std::string> required;
  for (std::string line; std::getline(lines, line) && line != "Optional Arguments:";) {
    EXPECT_EQ(line.find("  ", 2), std::string::npos) << line;
    if (line.find(": optional: ") == std::string::npos) required.push_back(line);
  }
  ASSERT_EQ(required.size(), 2U);
  EXPECT_EQ(required[0], "Required Arguments:");
  EXPECT_EQ(required[1].find("  scene: "), 0U);
}

TEST(LaunchFiles, LetRvizStandInTheWorldFrameOfTheScene) {
  for (const char* file : {"sim.launch", "remote.launch", "fleet.launch"}) {
    EXPECT_EQ(rvizCommand({file, kScene}).options["-f"], "world") << file;
    EXPECT_EQ(rvizCommand({file, kScene, "world_frame:=map"}).options["-f"], "map") << file;
  }
}

}  // namespace rigid_body_sim
