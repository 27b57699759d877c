#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "node_driver.hpp"
#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

using test::Outcome;

std::string freshName() {
  static int count = 0;
  return "probe_" + std::to_string(++count);
}

/// Runs the node with the arguments, one string as a shell takes it, until it ends by itself. What
/// counts as its output is what it writes to standard error.
Outcome runNode(const std::string& arguments) {
  // a name of its own: private parameters stay on the server
  const std::string command = std::string(RIGID_BODY_SIM_NODE) + " __name:=" + freshName() + " " +
                              arguments + " 2>&1 >/dev/null";
  return test::runCommand(command);
}

pid_t startNode(const std::string& name, const std::string& scene = RIGID_BODY_SIM_TEST_SCENE) {
  const pid_t child = fork();
  if (child == 0) {
    execl(RIGID_BODY_SIM_NODE, "rigid_body_node", ("__name:=" + name).c_str(),
          ("_scene_file:=" + scene).c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  return child;
}

/// Sends the signal. Returns the exit code.
int exitCodeAfter(int signal, pid_t child) {
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool isOneLine(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

/// Runs a command that ends with that exit code and says one line, which has a part.
void expectOneLine(const std::string& command, int exit_code, const std::string& part) {
  const Outcome run = test::runCommand(command);
  EXPECT_EQ(run.exit_code, exit_code) << command;
  EXPECT_NE(run.out.find(part), std::string::npos) << command << ": " << run.out;
  EXPECT_TRUE(isOneLine(run.out)) << command << ": " << run.out;
}

/// Starts the node, waits for its services, and sends it the signal. Returns its exit code.
int exitCodeAfter(int signal) {
  const std::string name = freshName();
  const pid_t child = startNode(name);
  const bool up = ros::service::waitForService(name + "/reset", 20000);
  const int code = exitCodeAfter(signal, child);
  return up ? code : -1;
}

}  // namespace

struct Refusal {
  const char* arguments;
  const char* line;
};

class RefusedStart : public ::testing::TestWithParam<Refusal> {};

TEST_P(RefusedStart, SaysWhyInOneLineAndExitsWithOne) {
  const Outcome run = runNode(GetParam().arguments);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find(GetParam().line), std::string::npos) << run.out;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1) << run.out;
}

#define SCENE "_scene_file:=" RIGID_BODY_SIM_TEST_SCENE
INSTANTIATE_TEST_SUITE_P(
    Node, RefusedStart,
    ::testing::Values(
        Refusal{"", "exactly one must be given, got neither"},
        Refusal{SCENE " _scene:='time_step: 1'", "exactly one must be given, got both"},
        Refusal{SCENE " _publish_rate:=-1", "~publish_rate: must be a number > 0 and at most 1e9"},
        Refusal{SCENE " _publish_rate:=1.7e308", "~publish_rate: must be a number > 0 and at most"},
        Refusal{SCENE " _publish_rate:=fast", "~publish_rate: must be a number > 0"},
        Refusal{SCENE " _wrench_timeout:=-0.5", "~wrench_timeout: must be a finite number >= 0"},
        Refusal{SCENE " _start_paused:=1", "~start_paused: must be true or false, got '1'"},
        Refusal{SCENE " _publish_rat:=1", "~publish_rat: unknown, got '1'; known: body_topics"},
        Refusal{SCENE " _publish_clock:=true", "~publish_clock: must be false unless"},
        Refusal{SCENE " _reset_time:=true", "~reset_time: must be false unless ~publish_clock"},
        Refusal{SCENE " _start_time:=-1",
                "~start_time: must be a time >= 0 s that ROS can represent"},
        Refusal{"__name:=box " SCENE, "body 'box': name must not be that of the node"},
        Refusal{"_scene_file:=absent.yaml", "absent.yaml: cannot be opened"},
        Refusal{"_scene:=/tmp/top.yaml", "a path belongs in ~scene_file, got '/tmp/top.yaml'"},
        Refusal{"_scene:='time_step: -1'", "parameter ~scene:1: "}));

TEST(Node, RefusesAnArgumentThatIsNotForIt) {
  for (const char* argument : {"scene.yaml", "--bogus"}) {
    const Outcome run = runNode(argument + std::string(" " SCENE));
    EXPECT_EQ(run.exit_code, 2) << argument;
    EXPECT_NE(run.out.find(std::string("unknown argument '") + argument + "'"), std::string::npos)
        << run.out;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1) << run.out;
  }
}

TEST(Node, RefusesArgumentsThatRoscppWouldEndItFor) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"scene:=/tmp/x.yaml", "a parameter begins with _: _scene_file:=/tmp/x.yaml"},
      {"scene_file:=/tmp/x.yaml", "a parameter begins with _: _scene_file:=/tmp/x.yaml"},
      {"publish_rate:=50", "a parameter begins with _: _publish_rate:=50"},
      {"__name:=9bad", "a name given by := is not one of ROS"},
      {"__name:=", "__name must be followed by a name, got ''"},
      {"__master:=garbage", "__master must be like http://localhost:11311, got 'garbage'"},
      {"__master:=http://localhost", "__master must be like http://localhost:11311, got 'http:"},
      {"__master:=http://:11311", "__master must be like http://localhost:11311, got 'http:"},
      {"__master:=http://localhost:x", "__master must be like http://localhost:11311, got 'http:"},
      {"__tcpros_server_port:=x", "__tcpros_server_port [x] was not specified as a number"},
      {"odom:=/a.b", "a name given by := is not one of ROS"}};
  for (const auto& [arguments, line] : cases)
    expectOneLine(RIGID_BODY_SIM_NODE " " SCENE " " + arguments + " 2>&1 >/dev/null", 2, line);
}

TEST(Examples, RefuseANameThatIsNotOneOfRos) {
  for (const char* program : {RIGID_BODY_SIM_DEMO_PUSHER, RIGID_BODY_SIM_DRONE_PILOT})
    expectOneLine(std::string(program) + " __name:=9bad 2>&1 >/dev/null", 2, "9bad");
}

TEST(Node, SaysWhereAParameterOfAnEarlierStartIsAndHowToDeleteIt) {
  const std::string name = "/probe_with_a_past";
  ros::param::set(name + "/publish_rat", 50);
  const std::string command =
      RIGID_BODY_SIM_NODE " __name:=probe_with_a_past " SCENE " _publish_rate:=50 2>&1 >/dev/null";
  const Outcome run = test::runCommand(command);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("rosparam delete " + name + "/publish_rat\n"), std::string::npos)
      << run.out;
  EXPECT_TRUE(isOneLine(run.out)) << run.out;
}

TEST(Node, SaysThatItsHelpCannotBeWritten) {
  for (const char* program : {RIGID_BODY_SIM_NODE, RIGID_BODY_SIM_DEMO_PUSHER})
    expectOneLine(std::string(program) + " --help 2>&1 >/dev/full", 1,
                  "standard output cannot be written");
}

TEST(Node, EndsOnASignalWhileItWaitsForASceneThatNobodyWrites) {
  const TemporaryDirectory files;
  const std::string pipe = files.path("scene.yaml");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const int signal : {SIGTERM, SIGINT}) {
    const pid_t child = startNode(freshName(), pipe);
    // it has opened the pipe once this side opens, too, and then waits for the text
    const int end = open(pipe.c_str(), O_WRONLY);
    ASSERT_GE(end, 0);
    kill(child, signal);
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    close(end);
  }
}

TEST(Node, StopsWhereRosTimeEnds) {
  const std::string scene = sceneFile(R"(
time_step: 1.0e+9
bodies: [{name: rock, shape: {sphere: {radius: 1}}, mass: 1.0}]
)");
  const Outcome run = runNode("_real_time_factor:=0 _publish_rate:=1e-9 _scene_file:=" + scene);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("has no stamp: ROS time ends in 2106"), std::string::npos) << run.out;
  EXPECT_TRUE(isOneLine(run.out)) << run.out;
}

TEST(Node, ExitsWithThreeWhenTheSimulationDiverges) {
  const std::string scene = sceneFile(R"(
time_step: 1.0
bodies: [{name: rocket, shape: {sphere: {radius: 1}}, mass: 1.0e-300}]
wrenches: [{body: rocket, frame: world, force: [1.0e+300, 0, 0], duration: 1000}]
)");
  const Outcome run = runNode("_real_time_factor:=0 _scene_file:=" + scene);
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.out.find("body 'rocket'"), std::string::npos) << run.out;
  EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1) << run.out;
}

TEST(Node, SaysThatItWaitsForAClockThatNobodySends) {
  ros::NodeHandle nh;
  bool told = false;
  const boost::function<void(const rosgraph_msgs::Log&)> receive =
      [&](const rosgraph_msgs::Log& message) {
        told = told || message.msg.find("waiting for /clock") == 0;
      };
  const ros::Subscriber log = nh.subscribe<rosgraph_msgs::Log>("/rosout", 100, receive);
  ros::param::set("/use_sim_time", true);
  const pid_t child = startNode(freshName());
  EXPECT_TRUE(NodeDriver::waitFor([&] { return told; }));
  ros::param::set("/use_sim_time", false);
  EXPECT_EQ(exitCodeAfter(SIGINT, child), 0);
}

// A node that went on to the end of what it computes would do so for minutes, beyond the time
// limit.

TEST(Node, EndsOnASignalWhileAutoTriesIntegrators) {
  std::string bodies, springs;
  for (int i = 0; i < 30; ++i) {
    const std::string name = "b" + std::to_string(i);
    bodies += "  - {name: " + name + ", shape: {box: [0.1, 0.2, 0.3]}, mass: 1}\n";
    springs += "  - {type: spring, from: {body: " + name +
               ", point: [0.05, 0, 0]}, to: {world: [0, 0.1, 1]}, stiffness: 4.0e+9}\n";
  }
  const std::string name = freshName();
  const pid_t child =
      startNode(name, sceneFile("time_step: 1\nbodies:\n" + bodies + "forces:\n" + springs));
  // ~get_loggers is there before the simulation is made
  EXPECT_TRUE(ros::service::waitForService(name + "/get_loggers", 20000));
  EXPECT_EQ(exitCodeAfter(SIGINT, child), 0);
}

TEST(Node, EndsOnASignalWithinAStep) {
  std::string bodies = "  - {name: ground, shape: {plane: {}}, fixed: true}\n";
  for (int i = 0; i < 60; ++i)
    bodies +=
        "  - {name: b" + std::to_string(i) + ", shape: {sphere: {radius: 0.1}}, position: [0, " +
        std::to_string(i) +
        ", 0.1], mass: 1.0e-6, twist: {frame: world, linear: [1, 0, 0], angular: [0, 10, 0]}}\n";
  const std::string name = freshName();
  const pid_t child = startNode(
      name, sceneFile("time_step: 0.5\ngravity: [0, 0, -9.8]\nbodies:\n" + bodies +
                      "forces: [{type: contact, between: [ground, all], stiffness: 1.0e+15, "
                      "restitution: 0.5, at: 3, friction: 0.4}]\n"));
  // the last thing before the first step
  EXPECT_TRUE(ros::service::waitForService(name + "/set_real_time_factor", 20000));
  EXPECT_EQ(exitCodeAfter(SIGINT, child), 0);
}

TEST(Node, EndsCleanlyOnSigint) { EXPECT_EQ(exitCodeAfter(SIGINT), 0); }

TEST(Node, EndsCleanlyOnSigterm) { EXPECT_EQ(exitCodeAfter(SIGTERM), 0); }

}  // namespace rigid_body_sim
