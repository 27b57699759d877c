#include <string>
#include <thread>
#include <vector>

#include <geometry_msgs/PointStamped.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <rigid_body_sim/AppliedWrenches.h>
#include <rigid_body_sim/SetRealTimeFactor.h>
#include <rigid_body_sim/Step.h>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "message_bytes.hpp"
#include "node_driver.hpp"
#include "ros/messages/conversions.hpp"
#include "support/run_command.hpp"

/// Time that goes in step with messages: closed loops, and controllers that do not answer.
namespace rigid_body_sim {
namespace {

constexpr double kPeriod = 0.02;  // [s]

/// The speed [rad/s] that the controller commands: nonlinear, so that a step more or less of delay
/// shows in every later bit.
double commandedSpeed(const nav_msgs::Odometry& odometry) {
  return 500 + 400 * odometry.twist.twist.angular.x * odometry.pose.pose.orientation.y;
}

/// A controller of one node: answers every odometry.
class Controller {
 public:
  explicit Controller(const std::string& space)
      : command_(nh_.advertise<sensor_msgs::JointState>(space + "/ship/command", 100)) {
    const boost::function<void(const nav_msgs::Odometry&)> answer =
        [this](const nav_msgs::Odometry& odometry) {
          const bool repeats =
              !received.empty() && received.back().header.stamp == odometry.header.stamp;
          if (!repeats) received.push_back(odometry);
          sensor_msgs::JointState command;
          command.header.stamp = odometry.header.stamp;
          command.name = {"left"};
          command.velocity = {commandedSpeed(odometry)};
          command_.publish(command);
        };
    odometry_ = nh_.subscribe<nav_msgs::Odometry>(space + "/ship/odom", 100000, answer);
  }

  std::vector<nav_msgs::Odometry> received;  // without repetitions of the standing state

 private:
  ros::NodeHandle nh_;
  ros::Publisher command_;
  ros::Subscriber odometry_;
};

Simulation shipSimulation() {
  const Scene scene = loadScene(RIGID_BODY_SIM_MOTORS_SCENE);
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

/// The odometry of every step, the loop closed without a delay every second step.
std::vector<nav_msgs::Odometry> closedLoop(std::size_t count, const ros::Time& start) {
  const TimeOrigin origin{start};
  Simulation sim = shipSimulation();
  std::vector<nav_msgs::Odometry> all;
  while (all.size() < count) {
    all.push_back(
        toOdometry(sim.world().bodies[0], sim.body(0), "world", origin.stamp(sim.time())));
    if (sim.steps() % 2 == 0) {
      ActuatorCommand command;
      command.actuator = 1;
      command.value = commandedSpeed(all.back());
      command.start = sim.time();
      command.end = sim.time() + 0.5;
      sim.command(command);
    }
    sim.step();
  }
  return all;
}

bool setPaused(const std::string& node, bool paused) {
  std_srvs::SetBool call;
  call.request.data = paused;
  return ros::service::call(node + "/pause", call) && call.response.success;
}

/// Returns the rule that the factor breaks; empty if none.
std::string setFactor(const std::string& node, double factor) {
  SetRealTimeFactor call;
  call.request.factor = factor;
  EXPECT_TRUE(ros::service::call(node + "/set_real_time_factor", call));
  return call.response.message;
}

Step::Response takeSteps(const std::string& node, std::uint32_t steps) {
  Step call;
  call.request.steps = steps;
  EXPECT_TRUE(ros::service::call(node + "/step", call));
  return call.response;
}

/// A node of its own, until it ends; of what it prints standard error alone.
test::Outcome runOfNode(const std::string& name, const std::string& arguments) {
  return test::runCommand(RIGID_BODY_SIM_NODE " __name:=" + name +
                          " _scene_file:=" RIGID_BODY_SIM_MOTORS_SCENE " " + arguments +
                          " 2>&1 >/dev/null");
}

}  // namespace

TEST(Lockstep, ClosesTheLoopWithTheSameBytesAtEveryPace) {
  Controller fastest("/fastest"), seven_times("/seven_times");
  // the pace may change, too, while the node waits: it waits for this test now
  ASSERT_TRUE(NodeDriver::waitFor([&] { return seven_times.received.size() > 20; }));
  const std::size_t before = seven_times.received.size();
  const ros::WallTime begin = ros::WallTime::now();
  EXPECT_EQ(setFactor("/seven_times/node", 0.5), "");
  ASSERT_TRUE(NodeDriver::waitFor([&] { return seven_times.received.size() > before + 20; }));
  // 0.2 s of simulation time, less the states that were on their way: two, and the step due then
  EXPECT_GT((ros::WallTime::now() - begin).toSec(), 0.3);
  EXPECT_EQ(setFactor("/seven_times/node", 0), "");
  for (Controller* controller : {&fastest, &seven_times}) {
    std::vector<nav_msgs::Odometry>& received = controller->received;
    ASSERT_TRUE(NodeDriver::waitFor([&] { return received.size() > 100; }));
    const std::vector<nav_msgs::Odometry> expected = closedLoop(100, received[0].header.stamp);
    for (std::size_t k = 0; k < expected.size(); ++k)
      ASSERT_EQ(bytesOf(received[k]), bytesOf(expected[k])) << k;
  }
}

// one of them a list of wrenches, the other of a type that the node does not know
TEST(Lockstep, WaitsForEachOfTwoTopics) {
  ros::NodeHandle nh;
  ros::Time last;
  const boost::function<void(const nav_msgs::Odometry&)> note =
      [&last](const nav_msgs::Odometry& odometry) { last = odometry.header.stamp; };
  const ros::Subscriber odometry =
      nh.subscribe<nav_msgs::Odometry>("/two_topics/ship/odom", 100, note);
  ros::Publisher wrenches = nh.advertise<AppliedWrenches>("/two_topics/node/wrenches", 10);
  ros::Publisher estimate = nh.advertise<geometry_msgs::PointStamped>("/two_topics/estimate", 10);
  ASSERT_TRUE(NodeDriver::waitFor([&] {
    return !last.isZero() && wrenches.getNumSubscribers() + estimate.getNumSubscribers() == 2;
  }));
  for (int k = 0; k < 5; ++k) {
    const ros::Time state = last;
    AppliedWrenches none;
    none.header.stamp = state;
    wrenches.publish(none);
    ros::spinOnce();
    EXPECT_EQ(last, state);
    geometry_msgs::PointStamped point;
    point.header.stamp = state + ros::Duration(0.5 * kPeriod);
    estimate.publish(point);
    ASSERT_TRUE(NodeDriver::waitFor([&] { return last >= state + ros::Duration(kPeriod); }));
    EXPECT_EQ(last, state + ros::Duration(kPeriod));
  }
}

TEST(Lockstep, IsServedWhileItWaits) {
  ASSERT_TRUE(ros::service::waitForService("/alone/node/reset", 20000));
  std_srvs::Trigger reset;
  EXPECT_TRUE(ros::service::call("/alone/node/reset", reset));
  EXPECT_FALSE(takeSteps("/alone/node", 1).success);
  for (const bool paused : {true, false, true}) EXPECT_TRUE(setPaused("/alone/node", paused));
  EXPECT_TRUE(ros::service::call("/alone/node/reset", reset));
}

// whichever call comes first: the step is refused, or it waits, and is ended
TEST(Lockstep, SaysOfAStepThatWaitsThatResumingHasEndedIt) {
  ASSERT_TRUE(ros::service::waitForService("/alone/node/step", 20000));
  std::string message;
  constexpr int kTries = 100;
  for (int i = 0; i < kTries && message.find("any more") == std::string::npos; ++i) {
    EXPECT_TRUE(setPaused("/alone/node", true));
    std::thread step([&] { message = takeSteps("/alone/node", 1).message; });
    EXPECT_EQ(setFactor("/alone/node", 1), "");  // a moment, for the step to be the first
    EXPECT_TRUE(setPaused("/alone/node", false));
    step.join();
  }
  EXPECT_EQ(message, "not paused any more: resuming has ended it");
  EXPECT_TRUE(setPaused("/alone/node", true));
}

// its answer to the first state is lost: nobody is connected with a topic that has just been opened
TEST(Lockstep, RepeatsTheStateToAControllerWhoseAnswerMayBeLost) {
  ros::NodeHandle nh;
  ros::Publisher command;
  std::vector<ros::Time> stamps;
  const boost::function<void(const nav_msgs::Odometry&)> answer =
      [&](const nav_msgs::Odometry& odometry) {
        if (!command) command = nh.advertise<sensor_msgs::JointState>("/alone/ship/command", 100);
        sensor_msgs::JointState message;
        message.header.stamp = odometry.header.stamp;
        message.name = {"left"};
        message.velocity = {500};
        command.publish(message);
        stamps.push_back(odometry.header.stamp);
      };
  EXPECT_TRUE(setPaused("/alone/node", false));
  const ros::Subscriber odometry =
      nh.subscribe<nav_msgs::Odometry>("/alone/ship/odom", 1000, answer);
  ASSERT_TRUE(NodeDriver::waitFor(
      [&] { return !stamps.empty() && stamps.back() > stamps[0] + ros::Duration(5 * kPeriod); }));
  EXPECT_TRUE(setPaused("/alone/node", true));
}

// while paused the node lives on; a caller of ~step is not kept longer than the timeout
TEST(Lockstep, NamesTheTopicThatDoesNotAnswerAStep) {
  ASSERT_TRUE(ros::service::waitForService("/paused/node/step", 20000));
  const Step::Response answer = takeSteps("/paused/node", 3);
  EXPECT_FALSE(answer.success);
  EXPECT_EQ(answer.message.find("lockstep: a message on /paused/ship/command stamped "), 0U)
      << answer.message;
  // however a pause ends, no step is taken without the message
  for (int i = 0; i < 10; ++i)
    for (const bool paused : {false, true}) EXPECT_TRUE(setPaused("/paused/node", paused));
  EXPECT_EQ(takeSteps("/paused/node", 1).stamp, answer.stamp);
  Controller controller("/paused");
  ASSERT_TRUE(NodeDriver::waitFor([&] { return !controller.received.empty(); }));
  ros::AsyncSpinner answers(1);
  answers.start();
  EXPECT_EQ(takeSteps("/paused/node", 5).message, "");
}

TEST(Lockstep, EndsWithOneLineThatNamesTheTopicOfADeadController) {
  const test::Outcome run =
      runOfNode("lonely", "_lockstep:=ship/command _lockstep_period:=0.02 _lockstep_timeout:=0.3");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out.find("rigid_body_node: lockstep: a message on /ship/command stamped "), 0U)
      << run.out;
  EXPECT_NE(run.out.find(" did not come within 0.3 s of wall time (~lockstep_timeout)\n"),
            std::string::npos)
      << run.out;
}

TEST(Lockstep, RefusesAPeriodOffTheStepsAndATopicOfTheNodeItself) {
  const test::Outcome uneven =
      runOfNode("uneven", "_lockstep:=ship/command _lockstep_period:=0.015");
  EXPECT_EQ(uneven.exit_code, 1);
  EXPECT_EQ(uneven.out,
            "rigid_body_node: parameter ~lockstep_period: must be a multiple of the scene's "
            "time_step 0.01 s, got 0.015\n");
  const test::Outcome own = runOfNode("own", "_lockstep:=ship/odom _lockstep_period:=0.02");
  EXPECT_EQ(own.exit_code, 1);
  EXPECT_EQ(own.out,
            "rigid_body_node: parameter ~lockstep: must name topics of others, such as a "
            "controller's, but this node itself publishes /ship/odom\n");
}

// "paused" alone would say that time stands; calls that come before the step are made again
TEST(Lockstep, SaysOfAPauseThatAStepGoesOn) {
  ASSERT_TRUE(ros::service::waitForService("/alone/node/step", 20000));
  const auto answerToPause = [](bool paused) {
    std_srvs::SetBool call;
    call.request.data = paused;
    ros::service::call("/alone/node/pause", call);
    return std::string(call.response.message);
  };
  const std::string expected = "paused, but the ~step under way goes on: false ends it";
  std::string answer;
  constexpr int kTries = 100;
  for (int i = 0; i < kTries && answer != expected; ++i) {
    answerToPause(true);
    std::thread step([] {
      Step call;
      call.request.steps = 1;
      ros::service::call("/alone/node/step", call);
    });
    for (int k = 0; k < kTries && answer != expected; ++k) answer = answerToPause(true);
    answerToPause(false);
    step.join();
  }
  EXPECT_EQ(answer, expected);
  EXPECT_TRUE(setPaused("/alone/node", true));
}

}  // namespace rigid_body_sim
