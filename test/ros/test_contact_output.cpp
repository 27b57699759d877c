#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/published_run.hpp"

namespace rigid_body_sim {
namespace {

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

Scene ballAndPlate() { return parseScene(kBallAndPlate, "test"); }

std::vector<ContactChange> changesOf(const test::PublishedRun& run) {
  std::vector<ContactChange> all;
  for (const Contacts& message : run.published.contacts)
    all.insert(all.end(), message.changes.begin(), message.changes.end());
  return all;
}

}  // namespace

TEST(ContactOutput, IsATopicOfScenesWithContactOnly) {
  const char* const kFreeBall =
      "time_step: 1\nbodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1}]";
  const test::PublishedRun touching(ballAndPlate(), 100);
  const test::PublishedRun free(parseScene(kFreeBall, "test"), 100);
  EXPECT_EQ(touching.published.names.count("~contacts"), 1U);
  EXPECT_EQ(free.published.names.count("~contacts"), 0U);
}

TEST(ContactOutput, NamesTouchesAndReleasesAtTheirInstants) {
  test::PublishedRun run(ballAndPlate(), 10);
  run.runUntil(0.5);
  std::vector<ContactChange> of_ball;
  for (const ContactChange& change : changesOf(run))
    if (change.body == "ball") of_ball.push_back(change);
  ASSERT_EQ(of_ball.size(), 2U);
  EXPECT_TRUE(of_ball[0].touch);
  EXPECT_NEAR(of_ball[0].time, kTouch, 1e-9);
  EXPECT_NEAR((of_ball[0].stamp - run.origin.start).toSec(), kTouch, 2e-9);
  EXPECT_EQ(of_ball[0].other, "ground");
  EXPECT_NEAR(of_ball[0].position.x, 1, 1e-9);
  EXPECT_NEAR(of_ball[0].position.y, 2, 1e-9);
  EXPECT_NEAR(of_ball[0].position.z, 0, 1e-6);
  EXPECT_FALSE(of_ball[1].touch);
  EXPECT_GT(of_ball[1].time, kTouch);
}

TEST(ContactOutput, RepeatsNoChangeAndLosesNone) {
  test::PublishedRun seldom(ballAndPlate(), 3), often(ballAndPlate(), 1000);
  seldom.runUntil(0.7);
  often.runUntil(0.7);
  const auto few = changesOf(seldom), all = changesOf(often);
  ASSERT_GT(all.size(), 2U);
  // those after the last message are still to come
  ASSERT_LE(few.size(), all.size());
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].time, all[i].time);
  for (std::size_t i = few.size(); i < all.size(); ++i) EXPECT_GT(all[i].time, 2.0 / 3 - 1e-3);
}

TEST(ContactOutput, CarriesTheWeightOfWhatRests) {
  test::PublishedRun run(ballAndPlate(), 100);
  run.runUntil(3);
  const Contacts& last = run.published.contacts.back();
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
  test::PublishedRun run(ballAndPlate(), 100);
  run.published.subscribers = 0;
  run.runUntil(0.4);  // the ball has touched
  EXPECT_TRUE(run.published.contacts.empty());
  run.published.subscribers = 1;
  run.runUntil(0.45);
  for (const ContactChange& change : changesOf(run)) EXPECT_GT(change.time, 0.4 - 2e-3);
}

TEST(ContactOutput, GreetsWithWhatTouchesWhileTimeStands) {
  test::PublishedRun run(ballAndPlate(), 100);
  run.runUntil(0.1);
  const std::size_t before = run.published.contacts.size();
  run.published.come.at("~contacts")();
  EXPECT_EQ(run.published.contacts.size(), before);
  run.outputs.setStanding(true);
  run.published.come.at("~contacts")();
  ASSERT_EQ(run.published.contacts.size(), before + 1);
  EXPECT_EQ(run.published.contacts.back().contacts.size(), 4U);
  EXPECT_TRUE(run.published.contacts.back().changes.empty());
}

}  // namespace rigid_body_sim
