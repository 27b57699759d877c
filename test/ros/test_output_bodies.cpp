#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ros/outputs/live_markers.hpp"
#include "support/published_run.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

std::vector<std::string> children(const tf2_msgs::TFMessage& message) {
  std::vector<std::string> frames;
  for (const auto& transform : message.transforms) frames.push_back(transform.child_frame_id);
  return frames;
}

std::set<int> trailIds(const MarkerArray& message, int action) {
  std::set<int> ids;
  for (const Marker& marker : message.markers)
    if (marker.ns == "motion/trail" && marker.action == action) ids.insert(marker.id);
  return ids;
}

/// A run of which only live markers are published.
struct MarkedRun : test::PublishedRun {
  MarkedRun() : test::PublishedRun(0.01) {}

  void publish() {
    simulation.step();
    markers.publish(Snapshot(simulation, simulation.time()), ros::Time(1));
  }

  MarkerArray message;
  LiveMarkers markers{
      {[] { return 1; }, [this](const MarkerArray& all, const ros::Time&) { message = all; }},
      "world",
      {"box", "ball", "post"}};
};

}  // namespace

TEST(Outputs, LeaveOutABodyThatIsRemovedUntilItIsAddedAgain) {
  using Names = std::vector<std::string>;
  test::PublishedRun run(0.01);
  run.steps(1);
  EXPECT_EQ(run.published.states.back().name, (Names{"box", "ball", "post"}));
  EXPECT_EQ(children(run.published.tf.back()), (Names{"box", "ball"}));
  const std::size_t odometry_of_box = run.published.odometry.at("box/odom").size();

  run.outputs.remove(0);
  run.steps(3);
  EXPECT_EQ(run.published.states.back().name, (Names{"ball", "post"}));
  EXPECT_EQ(run.published.states.back().pose.size(), 2U);
  EXPECT_EQ(run.published.states.back().pose[1].position.x, 5);
  EXPECT_EQ(children(run.published.tf.back()), Names{"ball"});
  EXPECT_EQ(run.published.odometry.at("box/odom").size(), odometry_of_box);

  run.outputs.add(0, openBodyTopics(run.published, run.world, 0));
  run.steps(1);
  EXPECT_EQ(run.published.states.back().name, (Names{"box", "ball", "post"}));
  EXPECT_EQ(children(run.published.tf.back()), (Names{"box", "ball"}));
  EXPECT_GT(run.published.odometry.at("box/odom").size(), odometry_of_box);
  EXPECT_EQ(test::position(run.published.odometry.at("box/odom").back()),
            toBodyFrameMotion(run.world.bodies[0], run.simulation.body(0)).x_W);
}

TEST(LiveMarkers, DeleteTheTrailOfABodyThatIsRemoved) {
  MarkedRun run;
  run.markers.add(0, 0.1);
  run.markers.add(1, 0.1);
  run.publish();
  run.publish();
  EXPECT_EQ(trailIds(run.message, Marker::ADD).size(), 2U);

  run.markers.remove(0);
  run.publish();
  const std::set<int> of_ball = trailIds(run.message, Marker::ADD);
  const std::set<int> deleted = trailIds(run.message, Marker::DELETE);
  EXPECT_EQ(of_ball.size(), 1U);
  EXPECT_EQ(deleted.size(), static_cast<std::size_t>(Trail::kStrips));
  EXPECT_EQ(deleted.count(*of_ball.begin()), 0U);
  run.publish();
  EXPECT_TRUE(trailIds(run.message, Marker::DELETE).empty());
}

TEST(LiveMarkers, DeleteTheTrailOfABodyThatLeavesAndBeginAnotherWhereItComesIn) {
  MarkedRun run;
  run.markers.add(0, 0.1);
  for (int i = 0; i < 3; ++i) run.publish();
  EXPECT_EQ(run.message.markers.back().points.size(), 3U);
  run.simulation.setPresent(0, std::nullopt);
  run.markers.endTrail(0);
  run.publish();
  EXPECT_EQ(trailIds(run.message, Marker::DELETE).size(), static_cast<std::size_t>(Trail::kStrips));
  EXPECT_EQ(trailIds(run.message, Marker::ADD).size(), 0U);
  run.simulation.setPresent(0, initialState(run.scene, run.world).bodies[0]);
  for (int i = 0; i < 2; ++i) run.publish();
  EXPECT_TRUE(trailIds(run.message, Marker::DELETE).empty());
  EXPECT_EQ(run.message.markers.back().points.size(), 2U);  // none from where it left
}

TEST(Outputs, HaveTheFramesOnABodyWhileItIsPresent) {
  using Names = std::vector<std::string>;
  test::PublishedRun run(0.01);
  EXPECT_EQ(children(run.published.tf.front()), (Names{"box/tip", "post"}));
  EXPECT_EQ(run.published.tf.front().transforms[0].header.frame_id, "box");
  run.steps(2);
  const std::size_t before = run.published.tf.size();
  run.simulation.setPresent(1, std::nullopt);  // on which there is nothing
  run.outputs.followBodies();
  EXPECT_EQ(run.published.tf.size(), before);
  run.simulation.setPresent(0, std::nullopt);
  run.outputs.followBodies();
  ASSERT_EQ(run.published.tf.size(), before + 1);
  EXPECT_EQ(children(run.published.tf.back()), Names{"post"});
  run.simulation.setPresent(0, initialState(run.scene, run.world).bodies[0]);
  run.outputs.followBodies();
  EXPECT_EQ(children(run.published.tf.back()), (Names{"box/tip", "post"}));
  EXPECT_EQ(run.published.tf.back().transforms[0].header.stamp,
            run.origin.stamp(run.simulation.time()));
}

// Else rviz would have no frame for it before a step is taken.
TEST(Outputs, SendTheFrameOfABodyThatComesInWhileTimeStands) {
  test::PublishedRun run(0.01);
  run.steps(2);
  run.outputs.setStanding(true);
  run.simulation.setPresent(1, std::nullopt);
  run.outputs.followBodies();
  const std::size_t before = run.published.tf.size();
  run.simulation.setPresent(1, initialState(run.scene, run.world).bodies[1]);
  run.outputs.followBodies();
  ASSERT_EQ(run.published.tf.size(), before + 1);
  EXPECT_EQ(children(run.published.tf.back()), std::vector<std::string>{"ball"});
  run.outputs.setStanding(false);
  run.simulation.setPresent(1, std::nullopt);
  run.outputs.followBodies();
  run.simulation.setPresent(1, initialState(run.scene, run.world).bodies[1]);
  run.outputs.followBodies();
  EXPECT_EQ(run.published.tf.size(), before + 1);  // the next state is due soon
}

TEST(Outputs, AreReadyForALawOfWhichABodyIsAbsent) {
  const Scene scene = parseScene(R"(
time_step: 0.01
bodies:
  - {name: guest, shape: {sphere: {radius: 1}}, mass: 1, absent: true, points: {tip: {}}}
  - {name: ground, shape: {plane: {}}, fixed: true}
forces:
  - {type: spring, from: {body: guest}, to: {world: [0, 0, 3]}, stiffness: 10}
  - {type: contact, between: [guest, ground], stiffness: 1.0e4}
)",
                                 "test");
  test::PublishedRun run(scene, 100);
  EXPECT_EQ(children(run.published.tf.front()), std::vector<std::string>{"ground"});
  // as the node opens its topics, by the world of the simulation
  test::PublishedMessages of_node;
  openTopics(of_node, run.simulation.world(), {true});
  EXPECT_EQ(of_node.names, run.published.names);
  EXPECT_EQ(of_node.names.count("~law_forces"), 1U);
  EXPECT_EQ(of_node.names.count("~contacts"), 1U);
  run.steps(1);
  EXPECT_TRUE(run.published.law_forces.back().forces.empty());
  EXPECT_TRUE(run.published.contacts.empty() || run.published.contacts.back().contacts.empty());

  BodyState above = initialState(scene, run.world).bodies[0];
  above.x_W.z() = 0.99;
  run.simulation.setPresent(0, above);
  run.outputs.followBodies();
  run.steps(1);
  EXPECT_EQ(run.published.law_forces.back().forces.size(), 1U);
  EXPECT_EQ(run.published.contacts.back().contacts.size(), 1U);
}

TEST(Outputs, AreSilentOfABodyThatIsAbsent) {
  using Names = std::vector<std::string>;
  test::PublishedRun run(0.01);
  run.outputs.setStanding(true);
  run.outputs.follow(0);
  run.steps(2);
  EXPECT_EQ(children(run.published.tf.back()), (Names{"box", "ball", "followed_body"}));
  const std::size_t odometry_of_box = run.published.odometry.at("box/odom").size();
  const std::size_t accelerations_of_box = run.published.accelerations.at("box/accel").size();
  const std::size_t wrenches_on_box = run.published.applied.at("box/applied_wrench").size();

  run.simulation.setPresent(0, std::nullopt);
  run.outputs.followBodies();
  run.steps(3);
  for (const char* topic : {"box/odom", "box/accel", "box/applied_wrench"})
    run.published.come.at(topic)();  // nor is a subscriber greeted
  EXPECT_EQ(run.published.states.back().name, (Names{"ball", "post"}));
  EXPECT_EQ(run.published.states.back().pose.at(1).position.x, 5);
  EXPECT_EQ(children(run.published.tf.back()), Names{"ball"});
  EXPECT_EQ(run.published.odometry.at("box/odom").size(), odometry_of_box);
  EXPECT_EQ(run.published.accelerations.at("box/accel").size(), accelerations_of_box);
  EXPECT_EQ(run.published.applied.at("box/applied_wrench").size(), wrenches_on_box);

  run.simulation.setPresent(0, initialState(run.scene, run.world).bodies[0]);
  run.outputs.followBodies();
  run.steps(1);
  EXPECT_EQ(run.published.states.back().name, (Names{"box", "ball", "post"}));
  EXPECT_EQ(children(run.published.tf.back()), (Names{"box", "ball", "followed_body"}));
  EXPECT_GT(run.published.odometry.at("box/odom").size(), odometry_of_box);
}

}  // namespace rigid_body_sim
