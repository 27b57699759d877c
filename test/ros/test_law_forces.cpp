#include <map>
#include <string>

#include <gtest/gtest.h>

#include "ros/outputs/law_forces.hpp"
#include "ros/outputs/live_markers.hpp"
#include "support/published_run.hpp"

/// What the node publishes of springs and tethers.
namespace rigid_body_sim {
namespace {

/// A ball that falls 0.2 m from a fixed hook until its tether of 0.5 m is taut, and one that is
/// pushed by a spring to the ball.
const char* const kHung = R"(
time_step: 0.01
horizon: 0.3
gravity: [0, 0, -10]
bodies:
  - {name: hook, shape: {sphere: {radius: 0.1}}, mass: 1, position: [0, 0, 3], fixed: true}
  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 2, position: [0, 0, 2.7]}
  - {name: other, shape: {sphere: {radius: 0.2}}, mass: 1, position: [1, 0, 2.7]}
forces:
  - {type: central_gravity, mu: 1.0e-9}
  - {type: tether, from: {body: ball, point: [0, 0, 0.1]}, to: {body: hook}, stiffness: 1000, length: 0.5}
  - {type: spring, from: {body: ball}, to: {body: other}, stiffness: 0.001, rest_length: 3}
)";

test::PublishedRun hungRun() { return test::PublishedRun(parseScene(kHung, "test"), 100); }

}  // namespace

TEST(LawForces, AreATopicOfScenesWithSpringsOrTethersOnly) {
  const test::PublishedRun run = hungRun(), free(0.01);
  EXPECT_EQ(run.published.names.count("~law_forces"), 1U);
  EXPECT_EQ(free.published.names.count("~law_forces"), 0U);
}

TEST(LawForces, AreTensionsAtTheInstantsOfTheStates) {
  test::PublishedRun run = hungRun();
  run.runUntil(0.1);
  const LawForces early = run.published.law_forces.back();
  EXPECT_EQ(early.header.frame_id, "world");
  EXPECT_EQ(early.header.stamp, run.published.states.back().header.stamp);
  ASSERT_EQ(early.forces.size(), 2U);
  const LawForce tether = early.forces[0], spring = early.forces[1];
  EXPECT_EQ(tether.law, "tether");
  EXPECT_EQ(tether.from, "ball");
  EXPECT_EQ(tether.to, "");
  EXPECT_TRUE(tether.slack);
  EXPECT_EQ(tether.tension, 0);
  EXPECT_NEAR(tether.length, 0.2 + 0.5 * 10 * 0.01, 1e-6);
  EXPECT_NEAR(tether.from_position.z, 2.8 - 0.05, 1e-6);
  EXPECT_EQ(tether.to_position.z, 3);
  EXPECT_EQ(spring.law, "spring");
  EXPECT_EQ(spring.to, "other");
  EXPECT_FALSE(spring.slack);
  EXPECT_NEAR(spring.tension, 0.001 * (1 - 3), 1e-7);

  run.runUntil(0.26);
  const LawForce taut = run.published.law_forces.back().forces[0];
  EXPECT_FALSE(taut.slack);
  EXPECT_GT(taut.tension, 1);
  EXPECT_NEAR(taut.tension, 1000 * (taut.length - 0.5), 1e-9);
}

TEST(LawForces, AreSentToWhoeverComesWhileTimeStands) {
  test::PublishedRun run = hungRun();
  run.published.come.at("~law_forces")();
  EXPECT_TRUE(run.published.law_forces.empty());
  run.outputs.setStanding(true);
  run.published.come.at("~law_forces")();
  ASSERT_EQ(run.published.law_forces.size(), 1U);
  EXPECT_EQ(run.published.law_forces[0].forces.size(), 2U);
}

TEST(LineMarker, ShowsByItsColourWhetherItPulls) {
  const World world = buildWorld(parseScene(kHung, "test"));
  LineForce line;
  for (std::size_t i = 0; i < world.laws.size(); ++i)
    if (world.laws[i]->name() == std::string("tether")) line.law = i;
  line.from = {1, {1, 2, 3}};
  line.to = {kWorld, {4, 5, 6}};
  line.is_slack = true;
  const visualization_msgs::Marker slack = lineMarker(line, world);
  line.is_slack = false;
  line.tension = 1;
  const visualization_msgs::Marker pulls = lineMarker(line, world);
  line.tension = -1;
  const visualization_msgs::Marker pushes = lineMarker(line, world);
  EXPECT_EQ(slack.ns, "law/tether");
  ASSERT_EQ(slack.points.size(), 2U);
  EXPECT_EQ(fromPoint(slack.points[1]), Vector3d(4, 5, 6));
  EXPECT_NEAR(slack.scale.x, 0.03 * 0.2, 1e-12);  // of the ball's diameter
  EXPECT_LT(slack.color.a, 1);
  EXPECT_GT(pulls.color.r, pulls.color.b);
  EXPECT_GT(pushes.color.b, pushes.color.r);
}

TEST(LiveMarkers, JoinTheEndsOfSpringsAndTethers) {
  test::PublishedRun run = hungRun();
  std::map<std::string, int> shown;
  const auto keep = [&](const visualization_msgs::MarkerArray& all, const ros::Time&) {
    for (const auto& marker : all.markers) {
      ++shown[marker.ns];
      if (marker.ns == "law/tether") {
        EXPECT_EQ(marker.header.frame_id, "world");
      }
    }
  };
  LiveMarkers markers({[] { return 1; }, keep}, "world", {"hook", "ball", "other"});
  markers.publish(Snapshot(run.simulation, 0), ros::Time(1));
  EXPECT_EQ(shown["law/tether"], 1);
  EXPECT_EQ(shown["law/spring"], 1);
}

}  // namespace rigid_body_sim
