#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/messages/tf_frames.hpp"
#include "ros/outputs/markers.hpp"
#include "ros/outputs/outputs.hpp"
#include "support/lopsided_box.hpp"

namespace rigid_body_sim {
namespace {

/// Keeps what is published.
struct Memory {
  template <class Message>
  Topic<Message> open(const std::string& name, bool) {
    return {[this] { return subscribers; },
            [this, name](const Message& message, const ros::Time&) { keep(name, message); },
            [this, name](const typename Topic<Message>::Greeting& greeting) {
              // who comes is a subscriber of its own
              come[name] = [this, name, greeting] {
                if (const auto message = greeting()) keep(name, *message);
              };
            }};
  }

  void keep(const std::string& name, const nav_msgs::Odometry& m) { odometry[name].push_back(m); }
  void keep(const std::string& name, const geometry_msgs::WrenchStamped& m) {
    applied[name].push_back(m);
  }
  void keep(const std::string&, const tf2_msgs::TFMessage& m) { tf.push_back(m); }
  void keep(const std::string&, const BodyStates& m) { states.push_back(m); }
  void keep(const std::string&, const rosgraph_msgs::Clock& m) { clock.push_back(m.clock); }
  template <class Message>
  void keep(const std::string& name, const Message&) {
    ++others[name];
  }

  std::map<std::string, std::function<void()>> come;
  std::size_t subscribers = 1;
  std::map<std::string, std::vector<nav_msgs::Odometry>> odometry;
  std::map<std::string, std::vector<geometry_msgs::WrenchStamped>> applied;
  std::vector<tf2_msgs::TFMessage> tf;  // the static ones first
  std::vector<BodyStates> states;
  std::vector<ros::Time> clock;
  std::map<std::string, int> others;
};

/// A run under wrenches, every step of it told.
struct ToldRun {
  /// With a rate of 0 [Hz] at every step.
  explicit ToldRun(double time_step, double rate = 0)
      : scene(sceneOf(time_step)), options(optionsOf(rate > 0 ? rate : 1 / time_step)) {}

  static NodeOptions optionsOf(double rate) {
    NodeOptions told;
    told.publish_clock = true;
    told.publish_rate = rate;
    return told;
  }

  static Scene sceneOf(double time_step) {
    Scene scene = parseScene(R"(
time_step: 1
gravity: [0.1, 0, -9.80665]
bodies:
)" + test::kLopsidedBox + R"(    position: [1, 2, 3]
    orientation: [0.5, 0.5, 0.5, 0.5]
    twist: {frame: world, linear: [1, -2, 3], angular: [0.5, -1, 2]}
    points: {tip: {position: [1, 0, -0.5]}}
  - {name: ball, shape: {sphere: {radius: 1}}, mass: 1}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 1, position: [5, 0, 0], fixed: true}
wrenches:
  - {body: box, frame: box/tip, force: [1, 2, 3], torque: [1, 0, 0], duration: 10}
  - {body: box, frame: world, point: [0.1, 0.2, 0.3], force: [3, 2, 1], duration: 10}
)",
                             "test");
    scene.time_step = time_step;
    return scene;
  }

  void steps(int count) {
    outputs.publishDue();
    for (int i = 0; i < count; ++i) {
      outputs.publishWithinStep(1e9);
      simulation.step();
      outputs.publishDue();
    }
  }

  Scene scene;
  NodeOptions options;
  World world = buildWorld(scene);
  Simulation simulation{world, initialState(scene, world)};
  TimeOrigin origin{ros::Time(1600000000, 123456789)};
  Memory memory;
  Outputs outputs{openTopics(memory, world, {true}), options, scene, simulation, origin};
};

Quaterniond attitude(const nav_msgs::Odometry& m) {
  const geometry_msgs::Quaternion& q = m.pose.pose.orientation;
  return {q.w, q.x, q.y, q.z};
}

Vector3d position(const nav_msgs::Odometry& m) { return fromPoint(m.pose.pose.position); }

/// The rotation vector from one attitude to another, in the axes of the first.
Vector3d rotationBetween(const Quaterniond& a, const Quaterniond& b) {
  const Eigen::AngleAxisd rotation(a.conjugate() * b);
  return rotation.angle() * rotation.axis();
}

/// By how much the twists of a run differ from the differences of its poses over two steps.
struct Worst {
  double linear = 0, angular = 0;
};

Worst twistErrors(double h) {
  ToldRun run(h);
  run.steps(static_cast<int>(std::lround(0.5 / h)));
  const std::vector<nav_msgs::Odometry>& told = run.memory.odometry.at("box/odom");
  Worst worst;
  for (std::size_t i = 1; i + 1 < told.size(); ++i) {
    const Vector3d v_W = (position(told[i + 1]) - position(told[i - 1])) / (2 * h);
    const Vector3d w_B = (rotationBetween(attitude(told[i]), attitude(told[i + 1])) -
                          rotationBetween(attitude(told[i]), attitude(told[i - 1]))) /
                         (2 * h);
    const geometry_msgs::Twist& twist = told[i].twist.twist;
    worst.linear =
        std::max(worst.linear, (v_W - attitude(told[i]) * fromVector3(twist.linear)).norm());
    worst.angular = std::max(worst.angular, (w_B - fromVector3(twist.angular)).norm());
  }
  return worst;
}

}  // namespace

TEST(Outputs, TwistIsTheDerivativeOfThePoseInBodyAxes) {
  // a central difference is off by h²/6 of the third derivative: a fourth for half the step
  const Worst coarse = twistErrors(0.002);
  const Worst fine = twistErrors(0.001);
  EXPECT_LT(coarse.linear, 1e-3);
  EXPECT_LT(coarse.angular, 1e-3);
  EXPECT_NEAR(coarse.linear / fine.linear, 4, 0.05);
  EXPECT_NEAR(coarse.angular / fine.angular, 4, 0.05);
}

TEST(Outputs, TfAndStatesAreTheOdometry) {
  ToldRun run(0.01);
  run.steps(50);
  const Memory& told = run.memory;
  ASSERT_EQ(told.tf.size(), 1U + 51);
  ASSERT_EQ(told.states.size(), 51U);
  for (std::size_t k = 0; k < 51; ++k) {
    const tf2_msgs::TFMessage& tf = told.tf[1 + k];
    ASSERT_EQ(tf.transforms.size(), 2U);
    for (std::size_t i : {0U, 1U}) {
      const std::string& name = run.world.bodies[i].name;
      const nav_msgs::Odometry& odometry = told.odometry.at(name + "/odom")[k];
      EXPECT_EQ(tf.transforms[i].child_frame_id, name);
      EXPECT_EQ(tf.transforms[i].header, odometry.header);
      EXPECT_EQ(fromVector3(tf.transforms[i].transform.translation), position(odometry));
      EXPECT_EQ(tf.transforms[i].transform.rotation, odometry.pose.pose.orientation);
      EXPECT_EQ(told.states[k].header, odometry.header);
      EXPECT_EQ(told.states[k].pose[i], odometry.pose.pose);
      EXPECT_EQ(told.states[k].twist[i], odometry.twist.twist);
    }
  }
}

TEST(Outputs, StampsAreThoseOfTheirInstantsWhateverTheStep) {
  for (const double h : {0.003, 0.01, 0.32}) {
    for (const double rate : {100.0, 7.0, 333.0}) {
      ToldRun run(h, rate);
      run.steps(static_cast<int>(std::lround(1.92 / h)));
      const std::vector<nav_msgs::Odometry>& told = run.memory.odometry.at("box/odom");
      ASSERT_EQ(told.size(), static_cast<std::size_t>(std::floor(1.92 * rate + 1e-6)) + 1);
      for (std::size_t k = 0; k < told.size(); ++k) {
        const auto expected = static_cast<std::uint64_t>(
            std::llround(1e9L * static_cast<long double>(k) / static_cast<long double>(rate)));
        ASSERT_EQ(told[k].header.stamp.toNSec() - run.origin.start.toNSec(), expected) << k;
      }
    }
  }
}

TEST(Outputs, ShowTheMotionBetweenStepsAsSmallStepsDo) {
  ToldRun small(0.01, 100);
  small.steps(192);
  ToldRun large(0.32, 100);
  large.steps(6);
  const std::vector<nav_msgs::Odometry>& a = small.memory.odometry.at("box/odom");
  const std::vector<nav_msgs::Odometry>& b = large.memory.odometry.at("box/odom");
  ASSERT_EQ(a.size(), b.size());
  // both are solved to rounding: some 200 times that of numbers up to 30
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_LT((position(a[k]) - position(b[k])).norm(), 1e-12) << k;
    ASSERT_LT(rotationBetween(attitude(a[k]), attitude(b[k])).norm(), 1e-12) << k;
    ASSERT_LT((fromVector3(a[k].twist.twist.linear) - fromVector3(b[k].twist.twist.linear)).norm(),
              1e-12)
        << k;
  }
}

TEST(Outputs, ShowTheWrenchThatActsAtTheInstantWithinAStep) {
  ToldRun run(0.32, 100);
  PointWrench push;
  push.body = push.point_frame = 1;
  push.force = {5, 0, 0};
  push.start = 0.105;
  push.end = 0.155;
  run.simulation.applyWrench("", push);
  run.steps(1);
  const std::vector<geometry_msgs::WrenchStamped>& told =
      run.memory.applied.at("ball/applied_wrench");
  ASSERT_EQ(told.size(), 33U);
  for (std::size_t k = 0; k < told.size(); ++k)
    EXPECT_EQ(fromVector3(told[k].wrench.force).norm(), k > 10 && k < 16 ? 5 : 0) << k;
}

TEST(Outputs, StampsStrictlyIncreaseThoughAStateIsAskedForTwice) {
  ToldRun run(0.003, 100);
  run.steps(7);
  run.outputs.publishNow();
  run.outputs.publishNow();
  run.steps(100);
  const std::vector<nav_msgs::Odometry>& told = run.memory.odometry.at("box/odom");
  ASSERT_EQ(told.size(), 34U);
  for (std::size_t k = 1; k < told.size(); ++k)
    ASSERT_LT(told[k - 1].header.stamp, told[k].header.stamp);
  EXPECT_EQ(told[3].header.stamp, run.origin.start + ros::Duration(0, 21000000));
  ASSERT_EQ(run.memory.clock.size(), 34U);
  for (std::size_t k = 1; k < 34; ++k) ASSERT_LT(run.memory.clock[k - 1], run.memory.clock[k]);
}

TEST(Outputs, BeginAtTheStartOfAClockFromZero) {
  ToldRun run(0.004, 100);
  run.origin = TimeOrigin{};
  run.steps(5);
  run.steps(0);  // once more for the same step
  const std::vector<ros::Time> expected{ros::Time(), ros::Time(0, 10000000),
                                        ros::Time(0, 20000000)};
  EXPECT_EQ(run.memory.clock, expected);
  std::vector<ros::Time> stamps;
  for (const nav_msgs::Odometry& told : run.memory.odometry.at("box/odom"))
    stamps.push_back(told.header.stamp);
  EXPECT_EQ(stamps, expected);

  // and again, when time has been set back
  run.simulation.reset(true);
  run.outputs.restart();
  run.steps(0);
  EXPECT_EQ(run.memory.clock.back(), ros::Time());
  EXPECT_EQ(run.memory.odometry.at("box/odom").back().header.stamp, ros::Time());
}

TEST(Outputs, SendTheStandingStateToWhoComes) {
  ToldRun run(0.003, 100);
  run.memory.subscribers = 0;
  run.steps(7);
  for (const auto& [name, come] : run.memory.come) come();
  EXPECT_TRUE(run.memory.odometry.empty());  // time runs: the next instant will do

  run.outputs.setStanding(true);
  for (const auto& [name, come] : run.memory.come) come();
  const ros::Time now = run.origin.start + ros::Duration(0, 21000000);
  ASSERT_EQ(run.memory.odometry.at("box/odom").size(), 1U);
  EXPECT_EQ(run.memory.odometry.at("box/odom")[0].header.stamp, now);
  EXPECT_EQ(position(run.memory.odometry.at("box/odom")[0]),
            toBodyFrameMotion(run.world.bodies[0], run.simulation.state().bodies[0]).x_W);
  ASSERT_EQ(run.memory.states.size(), 1U);
  EXPECT_EQ(run.memory.states[0].header.stamp, now);
  ASSERT_EQ(run.memory.tf.size(), 2U);
  EXPECT_EQ(run.memory.tf[1].transforms[0].header.stamp, now);
}

TEST(Outputs, NeverRepeatAStampOnTf) {
  ToldRun run(0.01, 100);
  run.outputs.setStanding(true);
  run.memory.come.at("/tf")();
  run.outputs.repeatState();
  run.outputs.setStanding(false);
  run.steps(3);
  run.outputs.setStanding(true);
  run.outputs.repeatState();
  run.outputs.repeatState();
  run.outputs.setStanding(false);
  run.steps(3);
  ASSERT_EQ(run.memory.tf.size(), 8U);  // the static one, and those of seven steps
  for (std::size_t k = 2; k < 8; ++k)
    ASSERT_LT(run.memory.tf[k - 1].transforms[0].header.stamp,
              run.memory.tf[k].transforms[0].header.stamp);
}

TEST(Outputs, RepeatClockAndStandingStateWithTheirStamps) {
  ToldRun run(0.01, 50);
  run.steps(3);
  run.outputs.setStanding(true);
  for (int i = 0; i < 3; ++i) {
    run.outputs.repeatClock();
    run.outputs.repeatState();
  }
  const ros::Time now = run.origin.start + ros::Duration(0, 30000000);
  ASSERT_EQ(run.memory.clock.size(), 4U + 3);
  ASSERT_EQ(run.memory.states.size(), 2U + 3);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(run.memory.clock[4 + k], now);
    EXPECT_EQ(run.memory.states[2 + k].header.stamp, now);
    EXPECT_EQ(run.memory.states[2 + k].pose, run.memory.states[2].pose);
  }
}

TEST(Outputs, BearThePrefixAndTheCovarianceThatAreAskedFor) {
  const Scene scene = ToldRun::sceneOf(0.01);
  NodeOptions options;
  options.tf_prefix = "robot_1";
  options.odometry_covariance = {1, 2, 3, 4, 5, 6};
  const World world = buildWorld(scene);
  const Simulation simulation(world, initialState(scene, world));
  const TimeOrigin origin;
  Memory memory;
  Outputs outputs(openTopics(memory, world, {}), options, scene, simulation, origin);
  outputs.publishDue();
  const nav_msgs::Odometry& odometry = memory.odometry.at("box/odom").at(0);
  EXPECT_EQ(odometry.header.frame_id, "world");
  EXPECT_EQ(odometry.child_frame_id, "robot_1/box");
  for (std::size_t i = 0; i < 36; ++i) {
    const double expected = i % 7 == 0 ? 1.0 + static_cast<double>(i) / 7 : 0;
    EXPECT_EQ(odometry.pose.covariance[i], expected);
    EXPECT_EQ(odometry.twist.covariance[i], expected);
  }
  EXPECT_EQ(memory.tf.at(0).transforms.at(0).header.frame_id, "robot_1/box");
  EXPECT_EQ(memory.tf.at(0).transforms.at(0).child_frame_id, "robot_1/box/tip");
  EXPECT_EQ(memory.tf.at(0).transforms.at(1).header.frame_id, "world");
  EXPECT_EQ(memory.tf.at(0).transforms.at(1).child_frame_id, "robot_1/post");
  EXPECT_EQ(memory.tf.at(1).transforms.at(0).child_frame_id, "robot_1/box");
  EXPECT_EQ(toMarkers(scene, TfFrames(scene, "robot_1")).markers.at(0).header.frame_id,
            "robot_1/box");
}

TEST(Outputs, LeaveOutTheTopicsOfSingleBodies) {
  const Scene scene = ToldRun::sceneOf(0.01);
  const World world = buildWorld(scene);
  Memory memory;
  TopicChoice choice;
  choice.single_bodies = false;
  EXPECT_TRUE(openTopics(memory, world, choice).bodies.empty());
}

TEST(Outputs, TellNothingToNobody) {
  ToldRun run(0.01);
  run.memory.subscribers = 0;
  run.steps(50);
  EXPECT_TRUE(run.memory.odometry.empty());
  EXPECT_TRUE(run.memory.states.empty());
  EXPECT_EQ(run.memory.tf.size(), 1U);  // the static one, latched before
  EXPECT_EQ(run.memory.others, (std::map<std::string, int>{{"~markers", 1}}));
}

TEST(Outputs, RepeatTheBodiesOnceForViewersWhoHaveCome) {
  ToldRun run(0.01);
  std::vector<int> sent;
  for (const std::size_t viewers : {0U, 0U, 1U, 1U, 1U, 2U, 2U, 1U, 1U}) {
    run.memory.subscribers = viewers;
    run.outputs.repeatBodies();
    sent.push_back(run.memory.others.at("~markers"));
  }
  EXPECT_EQ(sent, (std::vector<int>{1, 1, 1, 2, 2, 2, 3, 3, 3}));
}

}  // namespace rigid_body_sim
