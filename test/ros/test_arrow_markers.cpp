#include <gtest/gtest.h>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/arrow_markers.hpp"
#include "ros/outputs/trail.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

constexpr double kWeight = 2 * 9.80665;  // [N] of the body below

/// A ball of 2 kg and 0.5 m radius, turned by 90° about z and away from the origin.
class ArrowMarkers : public ::testing::Test {
 protected:
  ArrowMarkers() {
    bodies = {makeBody("ball", {2, Vector3d::Zero(), Matrix3d::Identity() * 0.2})};
    states.resize(1);
    states[0].x_W = Vector3d(1, 2, 3);
    states[0].q_WP = Quaterniond(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
    applied.point = Vector3d(0.5, 0, 0);
  }

  std::vector<Marker> arrows() const { return wrenchArrows(applied, bodies, states); }

  /// Where an arrow points, and how far [m].
  static Vector3d along(const Marker& arrow) {
    EXPECT_EQ(arrow.type, Marker::ARROW);
    EXPECT_EQ(arrow.points.size(), 2U);
    return fromPoint(arrow.points.at(1)) - fromPoint(arrow.points.at(0));
  }

  std::vector<Body> bodies;
  std::vector<BodyState> states;
  PointWrench applied;
};

}  // namespace

TEST_F(ArrowMarkers, SizeOfABallIsItsDiameter) { EXPECT_DOUBLE_EQ(sizeOf(bodies[0]), 1); }

TEST_F(ArrowMarkers, ForceIsDrawnFromItsPointInTheWorld) {
  applied.force = Vector3d(0, 0, kWeight);
  auto drawn = arrows();
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].ns, "wrench/force");
  // the point lies along y of the world, the weight makes an arrow of the size of the body
  EXPECT_LT((fromPoint(drawn[0].points.at(0)) - Vector3d(1, 2.5, 3)).norm(), 1e-15);
  EXPECT_LT((along(drawn[0]) - Vector3d(0, 0, 1)).norm(), 1e-15);

  applied.axes = 0;  // the body's own: x is y of the world
  applied.force = Vector3d(kWeight / 4, 0, 0);
  drawn = arrows();
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_LT((along(drawn[0]) - Vector3d(0, 0.5, 0)).norm(), 1e-15);
}

TEST_F(ArrowMarkers, CoupleIsDrawnFromThePointOfItsWrench) {
  applied.torque = Vector3d(kWeight / 2, 0, 0);
  const auto drawn = arrows();
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].ns, "wrench/couple");
  EXPECT_LT((fromPoint(drawn[0].points.at(0)) - Vector3d(1, 2.5, 3)).norm(), 1e-15);
  EXPECT_LT((along(drawn[0]) - Vector3d(1, 0, 0)).norm(), 1e-15);
}

TEST_F(ArrowMarkers, LengthsStayWithinATenthAndThreeTimesTheBody) {
  applied.force = Vector3d(kWeight * 1e-9, 0, 0);
  EXPECT_DOUBLE_EQ(along(arrows().at(0)).norm(), 0.1);
  applied.force = Vector3d(kWeight * 1e9, 0, 0);
  EXPECT_DOUBLE_EQ(along(arrows().at(0)).norm(), 3);
  applied.force = Vector3d(kWeight * 1e-13, 0, 0);
  EXPECT_TRUE(arrows().empty());
}

TEST_F(ArrowMarkers, AngularMomentumIsDrawnFromTheCentreOfMass) {
  EXPECT_TRUE(momentumArrows(bodies[0], states[0]).empty());
  states[0].L_W = Vector3d(0, 0.2 * 4 * M_PI, 0);  // two turns a second
  const auto drawn = momentumArrows(bodies[0], states[0]);
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].ns, "motion/angular_momentum");
  EXPECT_EQ(fromPoint(drawn[0].points.at(0)), states[0].x_W);
  EXPECT_LT((along(drawn[0]) - Vector3d(0, 2, 0)).norm(), 1e-15);
}

TEST(TrailMarkers, JoinEveryPointToTheOneBeforeAndReuseTheOldestStrip) {
  Trail trail(20, 0.1);
  EXPECT_FALSE(trail.add(Vector3d::Zero()));
  Vector3d end = Vector3d::Zero();
  int id = 20;
  for (int i = 1; i <= 2 * Trail::kStrips * Trail::kPointsPerStrip; ++i) {
    const auto strip = trail.add(Vector3d(i, 0, 0));
    ASSERT_TRUE(strip);
    ASSERT_GE(strip->points.size(), 2U);
    EXPECT_LE(strip->points.size(), Trail::kPointsPerStrip + 1U);
    EXPECT_EQ(fromPoint(*(strip->points.end() - 2)), end);
    EXPECT_EQ(fromPoint(strip->points.back()), Vector3d(i, 0, 0));
    end = Vector3d(i, 0, 0);
    if (strip->id == id) continue;
    EXPECT_EQ(strip->id, id == 20 + Trail::kStrips - 1 ? 20 : id + 1);
    id = strip->id;
  }
  EXPECT_EQ(id, 20 + Trail::kStrips - 1);
}

TEST(TrailMarkers, ABreakJoinsNothing) {
  Trail trail(0, 0.1);
  trail.add(Vector3d::Zero());
  trail.add(Vector3d::UnitX());
  trail.breakOff();
  EXPECT_FALSE(trail.add(Vector3d::UnitY()));
  const auto strip = trail.add(Vector3d::UnitZ());
  ASSERT_TRUE(strip);
  EXPECT_EQ(strip->id, 1);
  EXPECT_EQ(fromPoint(strip->points.at(0)), Vector3d::UnitY());
}

TEST_F(ArrowMarkers, ForcesOfContactAreDrawnWhereTheyAct) {
  ContactPoint contact;
  contact.other = kWorld;
  contact.position_W = Vector3d(1, 2, 2.5);
  contact.normal_force_W = Vector3d(0, 0, kWeight);
  EXPECT_EQ(contactArrows(contact, bodies).size(), 1U);  // no friction, no arrow of it
  contact.friction_force_W = Vector3d(-kWeight / 4, 0, 0);
  const auto drawn = contactArrows(contact, bodies);
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_EQ(drawn[0].ns, "contact/normal");
  EXPECT_EQ(drawn[1].ns, "contact/friction");
  for (const Marker& arrow : drawn) EXPECT_EQ(fromPoint(arrow.points.at(0)), contact.position_W);
  EXPECT_LT((along(drawn[0]) - Vector3d(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((along(drawn[1]) - Vector3d(-0.5, 0, 0)).norm(), 1e-15);
}

}  // namespace rigid_body_sim
