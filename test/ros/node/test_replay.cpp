#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <sys/wait.h>

#include <rigid_body_sim/AppliedWrench.h>
#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/BodyStates.h>
#include <rigid_body_sim/ClearWrenches.h>
#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/SetState.h>
#include <rigid_body_sim/Step.h>

#include "message_bytes.hpp"
#include "node_driver.hpp"
#include "ros/messages/conversions.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

const std::string kNode = "/rigid_body_node/";

template <class Service>
typename Service::Response callNode(const std::string& name, typename Service::Request request) {
  typename Service::Response response;
  EXPECT_TRUE(ros::service::waitForService(kNode + name, 20000));
  EXPECT_TRUE(ros::service::call(kNode + name, request, response)) << name;
  return response;
}

std_srvs::SetBool::Request flag(bool data) {
  std_srvs::SetBool::Request request;
  request.data = data;
  return request;
}

Step::Request steps(std::uint32_t count) {
  Step::Request request;
  request.steps = count;
  return request;
}

/// Receives what the node publishes, as rosbag record does.
class Replay : public ::testing::Test {
 protected:
  Replay() {
    receive<Input>(kNode + "inputs", [this](const Input& message) { inputs.push_back(message); });
    receive<BodyStates>(kNode + "states",
                        [this](const BodyStates& m) { states[m.header.stamp] = m; });
    for (const std::string body : {"box", "canary"}) {
      receive<nav_msgs::Odometry>("/" + body + "/odom", [this, body](const nav_msgs::Odometry& m) {
        odometry[{body, m.header.stamp}] = m;
      });
      receive<geometry_msgs::WrenchStamped>("/" + body + "/applied_wrench",
                                            [this, body](const geometry_msgs::WrenchStamped& m) {
                                              applied[{body, m.header.stamp}] = m;
                                            });
    }
  }

  template <class Message, class Function>
  void receive(const std::string& topic, const Function& f) {
    subscribers.push_back(
        nh.subscribe<Message>(topic, 100000,
                              boost::function<void(const boost::shared_ptr<const Message>&)>(
                                  [f](const boost::shared_ptr<const Message>& m) { f(*m); })));
  }

  bool isComplete(const ros::Time& stamp) const {
    const auto has = [&](const auto& messages, const char* body) {
      return messages.count({body, stamp}) > 0;
    };
    return states.count(stamp) > 0 && has(odometry, "box") && has(odometry, "canary") &&
           has(applied, "box") && has(applied, "canary");
  }

  /// Until every topic is received; then starts time over.
  void connect() {
    AppliedWrench nothing;
    nothing.header.frame_id = "world";
    nothing.body = "box";
    nothing.duration = ros::Duration(0, 1);
    ApplyWrench::Request request;
    request.wrench = nothing;
    ASSERT_TRUE(NodeDriver::waitFor([&] {
      callNode<Step>("step", steps(1));
      callNode<ApplyWrench>("apply_wrench", request);
      return !inputs.empty() && !states.empty() && isComplete(states.rbegin()->first);
    }));
    callNode<std_srvs::Trigger>("reset", {});
    callNode<Step>("step",
                   steps(1));  // inputs at time zero are recorded once the clock has left it
    ASSERT_TRUE(NodeDriver::waitFor([&] { return inputs.back().kind == Input::RESTART; }));
    states.clear();
    odometry.clear();
    applied.clear();
  }

  geometry_msgs::WrenchStamped everyday(const std::string& frame, double x) const {
    geometry_msgs::WrenchStamped message;
    message.header.frame_id = frame;
    message.wrench.force.x = std::sin(x);
    message.wrench.torque.y = std::cos(x);
    return message;
  }

  AppliedWrench general(const std::string& frame, double x) const {
    AppliedWrench message;
    message.header.frame_id = frame;
    message.body = x > 20 ? "box" : "canary";
    message.id = std::fmod(x, 3) > 1 ? "x" : "";
    message.duration = ros::Duration(0.0123 + 0.001 * x);
    message.point = toPoint(Vector3d(0.1, 0.2, x));
    message.wrench.force.z = 0.1 * std::sin(x);
    return message;
  }

  /// Messages on both wrench topics, arriving whenever they do, and every service between.
  void changeWhileItRuns() {
    box = nh.advertise<geometry_msgs::WrenchStamped>("/box/wrench", 1000);
    any = nh.advertise<AppliedWrench>(kNode + "wrench", 1000);
    ASSERT_TRUE(NodeDriver::waitFor(
        [&] { return box.getNumSubscribers() > 0 && any.getNumSubscribers() > 0; }));
    ApplyWrench::Request first;
    first.wrench = general("box", 1);
    EXPECT_TRUE(callNode<ApplyWrench>("apply_wrench", first).success);
    callNode<std_srvs::SetBool>("pause", flag(false));
    for (int i = 0; i < 40; ++i) {
      for (const char* frame : {"world", "box", "box/tip"}) box.publish(everyday(frame, i));
      any.publish(general(i % 2 == 0 ? "world" : "box/tip", i));
      const std::size_t received = states.size();
      ASSERT_TRUE(NodeDriver::waitFor([&] { return states.size() > received; }));
      if (i == 20) {
        SetState::Request set;
        set.body = set.frame = "canary";
        set.pose.orientation.w = 1;
        set.twist.angular.z = 1.0 / 3;
        EXPECT_TRUE(callNode<SetState>("set_state", set).success);
      }
      if (i == 30) {
        ClearWrenches::Request clear;
        clear.body = "box";
        EXPECT_TRUE(callNode<ClearWrenches>("clear_wrenches", clear).success);
      }
    }
    callNode<std_srvs::SetBool>("pause", flag(true));
  }

  /// Repeats by `simulate` what was recorded, to an end [s]; returns the path of its bag.
  std::string repeatedTo(double end) const {
    const std::string recorded = files.path("recorded.bag"), repeated = files.path("repeated.bag");
    {
      rosbag::Bag bag(recorded, rosbag::bagmode::Write);
      for (const Input& input : inputs)
        bag.write(kNode + "inputs", std::max(input.header.stamp, ros::TIME_MIN), input);
    }
    const std::string command =
        std::string(RIGID_BODY_SIM_SIMULATE) + " " RIGID_BODY_SIM_TEST_SCENE " --wrench-bag " +
        recorded + " --bag " + repeated + " --duration " + std::to_string(end) + " >/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << command;
    return repeated;
  }

  TemporaryDirectory files;
  ros::NodeHandle nh;
  std::vector<ros::Subscriber> subscribers;
  ros::Publisher box, any;  // of wrenches
  std::vector<Input> inputs;
  using Key = std::pair<std::string, ros::Time>;
  std::map<ros::Time, BodyStates> states;
  std::map<Key, nav_msgs::Odometry> odometry;
  std::map<Key, geometry_msgs::WrenchStamped> applied;
};

}  // namespace

TEST_F(Replay, OfARecordedBagGivesTheSameBytes) {
  connect();
  changeWhileItRuns();
  const ros::Time end = callNode<Step>("step", steps(50)).stamp;
  ASSERT_TRUE(NodeDriver::waitFor([&] { return isComplete(end); }));
  EXPECT_GT(inputs.size(), 100U);

  const rosbag::Bag bag(repeatedTo(end.toSec()), rosbag::bagmode::Read);

  // of the states at time zero and after the first step some or all messages came before connect()
  // had cleared what it received
  const auto complete = std::find_if(states.begin(), states.end(),
                                     [&](const auto& at) { return isComplete(at.first); });
  ASSERT_NE(complete, states.end());
  const ros::Time first = complete->first;
  std::size_t states_same = 0, odometry_same = 0, applied_same = 0;
  std::size_t states_repeated = 0, odometry_repeated = 0, applied_repeated = 0;
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    const std::string topic = message.getTopic();
    const std::string body = topic.substr(1, topic.find('/', 1) - 1);
    if (message.getTime() < first) continue;
    if (const auto m = message.instantiate<BodyStates>()) {
      ++states_repeated;
      states_same += bytesOf(*m) == bytesOf(states[m->header.stamp]);
    } else if (const auto odom = message.instantiate<nav_msgs::Odometry>()) {
      ++odometry_repeated;
      odometry_same += bytesOf(*odom) == bytesOf(odometry[{body, odom->header.stamp}]);
    } else if (const auto wrench = message.instantiate<geometry_msgs::WrenchStamped>()) {
      ++applied_repeated;
      applied_same += bytesOf(*wrench) == bytesOf(applied[{body, wrench->header.stamp}]);
    }
  }
  EXPECT_GE(states.size(), 90U);
  EXPECT_GE(states_repeated, 90U);
  EXPECT_EQ(states_same, states_repeated);
  EXPECT_EQ(odometry_same, odometry_repeated);
  EXPECT_EQ(applied_same, applied_repeated);
}

}  // namespace rigid_body_sim
