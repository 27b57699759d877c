#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/published_run.hpp"

namespace rigid_body_sim {

TEST(Outputs, StampsAreThoseOfTheirInstantsWhateverTheStep) {
  for (const double h : {0.003, 0.01, 0.32}) {
    for (const double rate : {100.0, 7.0, 333.0}) {
      test::PublishedRun run(h, rate);
      run.steps(static_cast<int>(std::lround(1.92 / h)));
      const std::vector<nav_msgs::Odometry>& published = run.published.odometry.at("box/odom");
      ASSERT_EQ(published.size(), static_cast<std::size_t>(std::floor(1.92 * rate + 1e-6)) + 1);
      for (std::size_t k = 0; k < published.size(); ++k) {
        const auto expected = static_cast<std::uint64_t>(
            std::llround(1e9L * static_cast<long double>(k) / static_cast<long double>(rate)));
        ASSERT_EQ(published[k].header.stamp.toNSec() - run.origin.start.toNSec(), expected) << k;
      }
    }
  }
}

TEST(Outputs, ShowTheMotionBetweenStepsAsSmallStepsDo) {
  test::PublishedRun small(0.01, 100);
  small.steps(192);
  test::PublishedRun large(0.32, 100);
  large.steps(6);
  const std::vector<nav_msgs::Odometry>& a = small.published.odometry.at("box/odom");
  const std::vector<nav_msgs::Odometry>& b = large.published.odometry.at("box/odom");
  ASSERT_EQ(a.size(), b.size());
  // both are solved to rounding: some 200 times that of numbers up to 30
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_LT((test::position(a[k]) - test::position(b[k])).norm(), 1e-12) << k;
    ASSERT_LT(test::rotationBetween(test::attitude(a[k]), test::attitude(b[k])).norm(), 1e-12) << k;
    ASSERT_LT((fromVector3(a[k].twist.twist.linear) - fromVector3(b[k].twist.twist.linear)).norm(),
              1e-12)
        << k;
  }
}

TEST(Outputs, ShowTheWrenchThatActsAtTheInstantWithinAStep) {
  test::PublishedRun run(0.32, 100);
  PointWrench push;
  push.body = push.point_frame = 1;
  push.force = {5, 0, 0};
  push.start = 0.105;
  push.end = 0.155;
  run.simulation.applyWrench("", push);
  run.steps(1);
  const std::vector<geometry_msgs::WrenchStamped>& published =
      run.published.applied.at("ball/applied_wrench");
  ASSERT_EQ(published.size(), 33U);
  for (std::size_t k = 0; k < published.size(); ++k)
    EXPECT_EQ(fromVector3(published[k].wrench.force).norm(), k > 10 && k < 16 ? 5 : 0) << k;
}

TEST(Outputs, StampsStrictlyIncreaseThoughAStateIsAskedForTwice) {
  test::PublishedRun run(0.003, 100);
  run.steps(7);
  run.outputs.publishNow();
  run.outputs.publishNow();
  run.steps(100);
  const std::vector<nav_msgs::Odometry>& published = run.published.odometry.at("box/odom");
  ASSERT_EQ(published.size(), 34U);
  for (std::size_t k = 1; k < published.size(); ++k)
    ASSERT_LT(published[k - 1].header.stamp, published[k].header.stamp);
  EXPECT_EQ(published[3].header.stamp, run.origin.start + ros::Duration(0, 21000000));
  ASSERT_EQ(run.published.clock.size(), 34U);
  for (std::size_t k = 1; k < 34; ++k)
    ASSERT_LT(run.published.clock[k - 1], run.published.clock[k]);
}

TEST(Outputs, BeginAtTheStartOfAClockFromZero) {
  test::PublishedRun run(0.004, 100);
  run.origin = TimeOrigin{};
  run.steps(5);
  run.steps(0);  // once more for the same step
  const std::vector<ros::Time> expected{ros::Time(), ros::Time(0, 10000000),
                                        ros::Time(0, 20000000)};
  EXPECT_EQ(run.published.clock, expected);
  std::vector<ros::Time> stamps;
  for (const nav_msgs::Odometry& published : run.published.odometry.at("box/odom"))
    stamps.push_back(published.header.stamp);
  EXPECT_EQ(stamps, expected);

  // and again, when time has been set back
  run.simulation.reset(true);
  run.outputs.restart(0);
  run.steps(0);
  EXPECT_EQ(run.published.clock.back(), ros::Time());
  EXPECT_EQ(run.published.odometry.at("box/odom").back().header.stamp, ros::Time());
}

TEST(Outputs, SendTheStandingStateToNewSubscribers) {
  test::PublishedRun run(0.003, 100);
  run.published.subscribers = 0;
  run.steps(7);
  for (const auto& [name, come] : run.published.come) come();
  EXPECT_TRUE(run.published.odometry.empty());  // time runs: the next instant will do

  run.outputs.setStanding(true);
  for (const auto& [name, come] : run.published.come) come();
  const ros::Time now = run.origin.start + ros::Duration(0, 21000000);
  ASSERT_EQ(run.published.odometry.at("box/odom").size(), 1U);
  EXPECT_EQ(run.published.odometry.at("box/odom")[0].header.stamp, now);
  EXPECT_EQ(test::position(run.published.odometry.at("box/odom")[0]),
            toBodyFrameMotion(run.world.bodies[0], run.simulation.state().bodies[0]).x_W);
  ASSERT_EQ(run.published.states.size(), 1U);
  EXPECT_EQ(run.published.states[0].header.stamp, now);
  ASSERT_EQ(run.published.tf.size(), 2U);
  EXPECT_EQ(run.published.tf[1].transforms[0].header.stamp, now);
}

// 1e11 instants in a step
TEST(Outputs, PassOverInstantsOfALongStepWhereNobodyLooks) {
  const Scene scene = parseScene(
      "time_step: 1.0e+9\nbodies: [{name: rock, shape: {sphere: {radius: 1}}, mass: 1}]", "test");
  const World world = buildWorld(scene);
  Simulation simulation(world, initialState(scene, world));
  const TimeOrigin origin;
  test::PublishedMessages published;
  published.subscribers = 0;
  Outputs outputs(openTopics(published, world, {}), NodeOptions(), scene, simulation, origin);
  outputs.publishDue();
  outputs.publishWithinStep(1e9);
  simulation.step();
  published.subscribers = 1;
  outputs.publishDue();
  ASSERT_EQ(published.states.size(), 1U);
  EXPECT_EQ(published.states[0].header.stamp, origin.stamp(1e9));
}

TEST(Outputs, NeverRepeatAStampOnTf) {
  test::PublishedRun run(0.01, 100);
  run.outputs.setStanding(true);
  run.published.come.at("/tf")();
  run.outputs.repeatState();
  run.outputs.setStanding(false);
  run.steps(3);
  run.outputs.setStanding(true);
  run.outputs.repeatState();
  run.outputs.repeatState();
  run.outputs.setStanding(false);
  run.steps(3);
  ASSERT_EQ(run.published.tf.size(), 8U);  // the static one, and those of seven steps
  for (std::size_t k = 2; k < 8; ++k)
    ASSERT_LT(run.published.tf[k - 1].transforms[0].header.stamp,
              run.published.tf[k].transforms[0].header.stamp);
}

TEST(Outputs, RepeatClockAndStandingStateWithTheirStamps) {
  test::PublishedRun run(0.01, 50);
  run.steps(3);
  run.outputs.setStanding(true);
  for (int i = 0; i < 3; ++i) {
    run.outputs.repeatClock();
    run.outputs.repeatState();
  }
  const ros::Time now = run.origin.start + ros::Duration(0, 30000000);
  ASSERT_EQ(run.published.clock.size(), 4U + 3);
  ASSERT_EQ(run.published.states.size(), 2U + 3);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(run.published.clock[4 + k], now);
    EXPECT_EQ(run.published.states[2 + k].header.stamp, now);
    EXPECT_EQ(run.published.states[2 + k].pose, run.published.states[2].pose);
  }
}

}  // namespace rigid_body_sim
