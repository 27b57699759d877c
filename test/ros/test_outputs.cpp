#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ros/messages/tf_frames.hpp"
#include "ros/outputs/markers.hpp"
#include "support/published_run.hpp"

namespace rigid_body_sim {
namespace {

/// By how much the twists of a run differ from the differences of its poses over two steps.
struct Worst {
  double linear = 0, angular = 0;
};

Worst twistErrors(double h) {
  test::PublishedRun run(h);
  run.steps(static_cast<int>(std::lround(0.5 / h)));
  const std::vector<nav_msgs::Odometry>& published = run.published.odometry.at("box/odom");
  Worst worst;
  for (std::size_t i = 1; i + 1 < published.size(); ++i) {
    const Vector3d v_W =
        (test::position(published[i + 1]) - test::position(published[i - 1])) / (2 * h);
    const Vector3d w_B =
        (test::rotationBetween(test::attitude(published[i]), test::attitude(published[i + 1])) -
         test::rotationBetween(test::attitude(published[i]), test::attitude(published[i - 1]))) /
        (2 * h);
    const geometry_msgs::Twist& twist = published[i].twist.twist;
    worst.linear = std::max(
        worst.linear, (v_W - test::attitude(published[i]) * fromVector3(twist.linear)).norm());
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
  test::PublishedRun run(0.01);
  run.steps(50);
  const test::PublishedMessages& published = run.published;
  ASSERT_EQ(published.tf.size(), 1U + 51);
  ASSERT_EQ(published.states.size(), 51U);
  for (std::size_t k = 0; k < 51; ++k) {
    const tf2_msgs::TFMessage& tf = published.tf[1 + k];
    ASSERT_EQ(tf.transforms.size(), 2U);
    for (std::size_t i : {0U, 1U}) {
      const std::string& name = run.world.bodies[i].name;
      const nav_msgs::Odometry& odometry = published.odometry.at(name + "/odom")[k];
      EXPECT_EQ(tf.transforms[i].child_frame_id, name);
      EXPECT_EQ(tf.transforms[i].header, odometry.header);
      EXPECT_EQ(fromVector3(tf.transforms[i].transform.translation), test::position(odometry));
      EXPECT_EQ(tf.transforms[i].transform.rotation, odometry.pose.pose.orientation);
      EXPECT_EQ(published.states[k].header, odometry.header);
      EXPECT_EQ(published.states[k].pose[i], odometry.pose.pose);
      EXPECT_EQ(published.states[k].twist[i], odometry.twist.twist);
    }
  }
}

TEST(Outputs, SendNoTfWhereAllBodiesAreAbsent) {
  const Scene scene = parseScene(
      "time_step: 0.01\n"
      "bodies: [{name: box, shape: {sphere: {radius: 1}}, mass: 1, absent: true}]",
      "test");
  const World world = buildWorld(scene);
  Simulation simulation(world, initialState(scene, world));
  const TimeOrigin origin;
  test::PublishedMessages published;
  Outputs outputs(openTopics(published, world, {}), NodeOptions(), scene, simulation, origin);
  for (int i = 0; i < 30; ++i) {
    outputs.publishDue();
    simulation.step();
  }
  EXPECT_GT(published.states.size(), 2U);
  EXPECT_TRUE(published.tf.empty());
}

TEST(Outputs, BearThePrefixAndTheCovarianceThatAreAskedFor) {
  const Scene scene = test::PublishedRun::sceneOf(0.01);
  NodeOptions options;
  options.tf_prefix = "robot_1";
  options.odometry_covariance = {1, 2, 3, 4, 5, 6};
  const World world = buildWorld(scene);
  const Simulation simulation(world, initialState(scene, world));
  const TimeOrigin origin;
  test::PublishedMessages published;
  Outputs outputs(openTopics(published, world, {}), options, scene, simulation, origin);
  outputs.publishDue();
  const nav_msgs::Odometry& odometry = published.odometry.at("box/odom").at(0);
  EXPECT_EQ(odometry.header.frame_id, "world");
  EXPECT_EQ(odometry.child_frame_id, "robot_1/box");
  for (std::size_t i = 0; i < 36; ++i) {
    const double expected = i % 7 == 0 ? 1.0 + static_cast<double>(i) / 7 : 0;
    EXPECT_EQ(odometry.pose.covariance[i], expected);
    EXPECT_EQ(odometry.twist.covariance[i], expected);
  }
  EXPECT_EQ(published.tf.at(0).transforms.at(0).header.frame_id, "robot_1/box");
  EXPECT_EQ(published.tf.at(0).transforms.at(0).child_frame_id, "robot_1/box/tip");
  EXPECT_EQ(published.tf.at(0).transforms.at(1).header.frame_id, "world");
  EXPECT_EQ(published.tf.at(0).transforms.at(1).child_frame_id, "robot_1/post");
  EXPECT_EQ(published.tf.at(1).transforms.at(0).child_frame_id, "robot_1/box");
  EXPECT_EQ(toMarkers(scene, TfFrames(scene, "robot_1")).markers.at(0).header.frame_id,
            "robot_1/box");
}

TEST(Outputs, LeaveOutTheTopicsOfSingleBodies) {
  const Scene scene = test::PublishedRun::sceneOf(0.01);
  const World world = buildWorld(scene);
  test::PublishedMessages published;
  TopicChoice choice;
  choice.single_bodies = false;
  EXPECT_TRUE(openTopics(published, world, choice).bodies.empty());
}

TEST(Outputs, PublishNothingWithoutSubscribers) {
  test::PublishedRun run(0.01);
  run.published.subscribers = 0;
  run.steps(50);
  EXPECT_TRUE(run.published.odometry.empty());
  EXPECT_TRUE(run.published.states.empty());
  EXPECT_EQ(run.published.tf.size(), 1U);  // the static one, latched before
  EXPECT_EQ(run.published.others, (std::map<std::string, int>{{"~markers", 1}}));
}

TEST(Outputs, RepeatTheBodiesOnceForViewersWhoHaveCome) {
  test::PublishedRun run(0.01);
  std::vector<int> sent;
  for (const std::size_t viewers : {0U, 0U, 1U, 1U, 1U, 2U, 2U, 1U, 1U}) {
    run.published.subscribers = viewers;
    run.outputs.repeatBodies();
    sent.push_back(run.published.others.at("~markers"));
  }
  EXPECT_EQ(sent, (std::vector<int>{1, 1, 1, 2, 2, 2, 3, 3, 3}));
}

}  // namespace rigid_body_sim
