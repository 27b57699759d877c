#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/outputs/outputs.hpp"

namespace rigid_body_sim {
namespace {

/// Keeps what is published on ~contacts.
struct ContactMemory {
  template <class Message>
  Topic<Message> open(const std::string& name, bool) {
    names.insert(name);
    return {[this] { return subscribers; },
            [this](const Message& message, const ros::Time&) { keep(message); },
            [this](const typename Topic<Message>::Greeting& greeting) { greet(greeting); }};
  }

  void keep(const Contacts& message) { messages.push_back(message); }
  template <class Message>
  void keep(const Message&) {}

  void greet(const Topic<Contacts>::Greeting& greeting) { come = greeting; }
  template <class Greeting>
  void greet(const Greeting&) {}

  std::vector<ContactChange> changes() const {
    std::vector<ContactChange> all;
    for (const Contacts& message : messages)
      all.insert(all.end(), message.changes.begin(), message.changes.end());
    return all;
  }

  std::set<std::string> names;
  std::size_t subscribers = 1;
  std::vector<Contacts> messages;
  Topic<Contacts>::Greeting come;
};

constexpr double kGravity = 9.80665;  // [m/s²]
constexpr double kHeight = 0.5;       // [m] of the ball's lowest point at the start
const double kTouch = std::sqrt(2 * kHeight / kGravity);

const char* const kBallAndPlate = R"(
gravity: [0, 0, -9.80665]
time_step: 0.001
bodies:
  - {name: ground, shape: {plane: {}}, fixed: true}
  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 1, position: [1, 2, 0.6]}
  - {name: plate, shape: {box: [0.4, 0.4, 0.1]}, mass: 2, position: [0, 0, 0.05]}
forces:
  - {type: contact, between: [ground, all], stiffness: 1.0e+5, dissipation: 1, friction: 0.5}
)";

/// A run that is published.
struct TouchingRun {
  explicit TouchingRun(double rate, const std::string& yaml = kBallAndPlate)
      : scene(parseScene(yaml, "test")) {
    options.publish_rate = rate;
    outputs.emplace(openTopics(memory, world, {}), options, scene, simulation, origin);
  }

  void runUntil(double t_end) {
    outputs->publishDue();
    while (simulation.time() < t_end - 1e-9) {
      outputs->publishWithinStep(1e9);
      simulation.step();
      outputs->publishDue();
    }
  }

  Scene scene;
  NodeOptions options;
  World world = buildWorld(scene);
  Simulation simulation{world, initialState(scene, world)};
  TimeOrigin origin{ros::Time(1600000000, 0)};
  ContactMemory memory;
  std::optional<Outputs> outputs;
};

}  // namespace

TEST(ContactOutput, IsATopicOfScenesWithContactOnly) {
  EXPECT_EQ(TouchingRun(100).memory.names.count("~contacts"), 1U);
  EXPECT_EQ(TouchingRun(100,
                        "time_step: 1\nbodies: [{name: a, shape: {sphere: {radius: 1}}, mass: "
                        "1}]")
                .memory.names.count("~contacts"),
            0U);
}

TEST(ContactOutput, NamesTouchesAndReleasesAtTheirInstants) {
  TouchingRun run(10);
  run.runUntil(0.5);
  std::vector<ContactChange> of_ball;
  for (const ContactChange& change : run.memory.changes())
    if (change.body == "ball") of_ball.push_back(change);
  ASSERT_EQ(of_ball.size(), 2U);
  EXPECT_TRUE(of_ball[0].touch);
  EXPECT_NEAR(of_ball[0].time, kTouch, 1e-9);
  EXPECT_NEAR((of_ball[0].stamp - ros::Time(1600000000, 0)).toSec(), kTouch, 2e-9);
  EXPECT_EQ(of_ball[0].other, "ground");
  EXPECT_NEAR(of_ball[0].position.x, 1, 1e-9);
  EXPECT_NEAR(of_ball[0].position.y, 2, 1e-9);
  EXPECT_NEAR(of_ball[0].position.z, 0, 1e-6);
  EXPECT_FALSE(of_ball[1].touch);
  EXPECT_GT(of_ball[1].time, kTouch);
}

TEST(ContactOutput, RepeatsNoChangeAndLosesNone) {
  TouchingRun seldom(3), often(1000);
  seldom.runUntil(0.7);
  often.runUntil(0.7);
  const auto few = seldom.memory.changes(), all = often.memory.changes();
  ASSERT_GT(all.size(), 2U);
  // those after the last message are still to come
  ASSERT_LE(few.size(), all.size());
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].time, all[i].time);
  for (std::size_t i = few.size(); i < all.size(); ++i) EXPECT_GT(all[i].time, 2.0 / 3 - 1e-3);
}

TEST(ContactOutput, CarriesTheWeightOfWhatRests) {
  TouchingRun run(100);
  run.runUntil(3);
  const Contacts& last = run.memory.messages.back();
  EXPECT_EQ(last.header.frame_id, "world");
  double weight = 0;
  int corners = 0;
  for (const ContactState& contact : last.contacts) {
    if (contact.body != "plate") continue;
    ++corners;
    weight += contact.normal_force.z;
    EXPECT_EQ(contact.other, "ground");
    EXPECT_NEAR(std::abs(contact.position.x), 0.2, 1e-3);
    EXPECT_NEAR(contact.penetration, std::pow(2 * kGravity / 4 / 1e5, 1 / 1.5), 1e-6);
    EXPECT_FALSE(contact.slips);
  }
  EXPECT_EQ(corners, 4);
  EXPECT_NEAR(weight, 2 * kGravity, 1e-3);
}

TEST(ContactOutput, IsNotComputedWithoutSubscribers) {
  TouchingRun run(100);
  run.memory.subscribers = 0;
  run.runUntil(0.4);  // the ball has touched
  EXPECT_TRUE(run.memory.messages.empty());
  run.memory.subscribers = 1;
  run.runUntil(0.45);
  for (const ContactChange& change : run.memory.changes()) EXPECT_GT(change.time, 0.4 - 2e-3);
}

TEST(ContactOutput, GreetsWithWhatTouchesWhileTimeStands) {
  TouchingRun run(100);
  run.runUntil(0.1);
  EXPECT_FALSE(run.memory.come());
  run.outputs->setStanding(true);
  const auto greeting = run.memory.come();
  ASSERT_TRUE(greeting);
  EXPECT_EQ(greeting->contacts.size(), 4U);
  EXPECT_TRUE(greeting->changes.empty());
}

}  // namespace rigid_body_sim
