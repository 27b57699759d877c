#include <cstdint>
#include <memory>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/spring.hpp>

#include "support/counted_law.hpp"
#include "support/published_run.hpp"

/// What many messages within a step in contact cost, counted in evaluations of a law.
namespace rigid_body_sim {
namespace {

/// A ball that bounces and slides, on a weak spring that counts how often it is asked.
struct CountedBounces {
  Scene scene = parseScene(R"(
time_step: 0.5
gravity: [0, 0, -9.80665]
bodies:
  - {name: ground, shape: {plane: {}}, fixed: true}
  - name: ball
    shape: {sphere: {radius: 0.1}}
    mass: 1
    position: [0, 0, 0.12]
    twist: {frame: world, linear: [1, 0, 0]}
    imus: {middle: {rate: 200}}
forces:
  - {type: contact, between: [ball, ground], stiffness: 1.0e+5, dissipation: 1, friction: 0.3}
)",
                           "test");
  std::int64_t asked = 0;
  World world = buildWorld(scene);

  CountedBounces() {
    const auto spring = std::make_shared<Spring>(
        Spring::End{1, {0, 0, 0}}, Spring::End{kWorld, {0, 0, 1}}, Spring::Constants{1e-3, 0, 0});
    world.laws.push_back(std::make_shared<test::CountedLaw>(spring, asked));
  }
  Simulation simulation() const { return {world, initialState(scene, world)}; }
};

/// All that is published within the first step.
struct PublishedStep {
  explicit PublishedStep(const CountedBounces& of)
      : bounces(of),
        simulation(of.simulation()),
        outputs(openTopics(published, of.world, {true}), options(), of.scene, simulation, origin) {}

  static NodeOptions options() {
    NodeOptions options;
    options.publish_rate = 300;
    return options;
  }

  const CountedBounces& bounces;
  Simulation simulation;
  TimeOrigin origin;
  test::PublishedMessages published;
  Outputs outputs;
};

TEST(OutputCost, OfManyMessagesWithinAStepIsThatOfTheStep) {
  CountedBounces bounces;
  PublishedStep run(bounces);
  bounces.asked = 0;
  run.outputs.publishWithinStep(1e9);
  const std::int64_t by_messages = bounces.asked;
  EXPECT_GT(run.published.states.size(), 140U);
  EXPECT_GT(run.published.imu.begin()->second.size(), 90U);
  bounces.asked = 0;
  run.simulation.step();
  // a sample ends a step of the integrator, and an acceleration asks once more; each from the start
  // of the step they would take some hundred times as much
  EXPECT_LT(by_messages, 12 * bounces.asked);
}

// Thousands of topics are not asked one by one at every instant.
TEST(OutputCost, OfTopicsThatNobodyAsksForIsOnceForEachWhoComesOrGoes) {
  const CountedBounces bounces;
  Simulation simulation = bounces.simulation();
  TimeOrigin origin;
  test::PublishedMessages published;
  OutputTopics topics = openTopics(published, bounces.world, {true});
  int asked = 0;
  std::size_t changes = 0, listeners = 0;
  const auto count = [&](auto& topic) { topic.subscribers = [&] { return ++asked, listeners; }; };
  ASSERT_EQ(topics.bodies.size(), 1U);
  count(topics.bodies[0].odometry);
  count(topics.bodies[0].acceleration);
  count(topics.bodies[0].applied_wrench);
  topics.changes = [&] { return changes; };
  Outputs outputs(std::move(topics), PublishedStep::options(), bounces.scene, simulation, origin);
  outputs.publishWithinStep(0.1);
  EXPECT_GT(published.states.size(), 20U);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(published.odometry.size(), 0U);
  ++changes, ++listeners;
  outputs.publishWithinStep(0.2);
  EXPECT_GT(published.odometry["ball/odom"].size(), 20U);
}

TEST(OutputCost, HasNoBitsThatDependOnWhoListens) {
  const CountedBounces bounces;
  PublishedStep always(bounces), late(bounces);
  late.published.subscribers = 0;
  for (PublishedStep* run : {&always, &late}) run->outputs.publishWithinStep(0.3);
  late.published.subscribers = 1;
  for (PublishedStep* run : {&always, &late}) run->outputs.publishWithinStep(1e9);
  ASSERT_GT(late.published.states.size(), 50U);
  EXPECT_EQ(late.published.states.back(), always.published.states.back());
  EXPECT_EQ(late.published.accelerations.at("ball/accel").back(),
            always.published.accelerations.at("ball/accel").back());
  const auto &imu = late.published.imu.begin()->second, &all = always.published.imu.begin()->second;
  ASSERT_LT(imu.size(), all.size());
  EXPECT_EQ(imu.back(), all.back());
}

}  // namespace
}  // namespace rigid_body_sim
