#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/math/isometry.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/build/contact_shape.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::Contains;
using ::testing::UnorderedElementsAre;

ContactShape shapeOf(const std::string& keys, const Isometry3d& X_PB = Isometry3d::Identity()) {
  const Scene scene = parseScene("time_step: 1\nbodies: [{name: a, " + keys + "}]\n", "s.yaml");
  return contactShapeOf(scene.bodies[0], X_PB);
}

}  // namespace

TEST(ContactShape, OfABoxAreItsCorners) {
  const ContactShape shape = shapeOf("shape: {box: [2, 4, 6]}, mass: 1");
  EXPECT_THAT(shape.points,
              UnorderedElementsAre(Vector3d(1, 2, 3), Vector3d(-1, 2, 3), Vector3d(1, -2, 3),
                                   Vector3d(-1, -2, 3), Vector3d(1, 2, -3), Vector3d(-1, 2, -3),
                                   Vector3d(1, -2, -3), Vector3d(-1, -2, -3)));
  EXPECT_TRUE(shape.balls.empty() && shape.rims.empty() && shape.ellipsoids.empty());
}

TEST(ContactShape, OfRoundSolidsAreBallsRimsAndEllipsoids) {
  const ContactShape sphere = shapeOf("shape: {sphere: {radius: 2}}, mass: 1");
  ASSERT_EQ(sphere.balls.size(), 1U);
  EXPECT_EQ(sphere.balls[0].radius, 2);

  const ContactShape capsule = shapeOf("shape: {capsule: {radius: 2, length: 3}}, mass: 1");
  ASSERT_EQ(capsule.balls.size(), 2U);
  EXPECT_EQ(capsule.balls[0].center_P, Vector3d(0, 0, -1.5));
  EXPECT_EQ(capsule.balls[1].center_P, Vector3d(0, 0, 1.5));
  EXPECT_EQ(shapeOf("shape: {capsule: {radius: 2, length: 0}}, mass: 1").balls.size(), 1U);

  const ContactShape cylinder = shapeOf("shape: {cylinder: {radius: 2, length: 3}}, mass: 1");
  ASSERT_EQ(cylinder.rims.size(), 2U);
  EXPECT_EQ(cylinder.rims[0].center_P, Vector3d(0, 0, -1.5));
  EXPECT_EQ(cylinder.rims[1].center_P, Vector3d(0, 0, 1.5));
  EXPECT_EQ(cylinder.rims[1].axis_P, Vector3d::UnitZ());
  EXPECT_EQ(cylinder.rims[1].radius, 2);

  const ContactShape cone = shapeOf("shape: {cone: {radius: 2, length: 4}}, mass: 1");
  ASSERT_EQ(cone.rims.size(), 1U);
  EXPECT_EQ(cone.rims[0].center_P, Vector3d(0, 0, -1));
  EXPECT_THAT(cone.points, UnorderedElementsAre(Vector3d(0, 0, 3)));

  const ContactShape ellipsoid = shapeOf("shape: {ellipsoid: [1, 2, 3]}, mass: 1");
  ASSERT_EQ(ellipsoid.ellipsoids.size(), 1U);
  EXPECT_EQ(ellipsoid.ellipsoids[0].semi_axes, Vector3d(1, 2, 3));
}

TEST(ContactShape, OfParticlesAndPartsAreThoseOfEach) {
  EXPECT_EQ(shapeOf("particles: [{mass: 1, position: [1, 0, 0]}, {mass: 1, position: [0, 1, 0]}, "
                    "{mass: 1, position: [0, 0, 1]}]")
                .points.size(),
            3U);
  const ContactShape parts = shapeOf(
      "parts: [{shape: {sphere: {radius: 1}}, mass: 1, position: [1, 0, 0]}, "
      "{shape: {box: [1, 1, 1]}, mass: 1, position: [0, 5, 0]}, "
      "{mass: 1, inertia: {ixx: 1, iyy: 1, izz: 1}, position: [0, 0, 3]}]");
  ASSERT_EQ(parts.balls.size(), 1U);
  EXPECT_EQ(parts.balls[0].center_P, Vector3d(1, 0, 0));
  EXPECT_EQ(parts.points.size(), 8U);
  EXPECT_THAT(parts.points, Contains(Vector3d(0.5, 5.5, -0.5)));
}

TEST(ContactShape, OfGivenPropertiesIsEmpty) {
  const std::string given = "mass: 1, inertia: {ixx: 1, iyy: 1, izz: 1}";
  EXPECT_TRUE(shapeOf(given).empty());
  EXPECT_EQ(shapeOf(given + ", collision: [{shape: {sphere: {radius: 2}}}]").balls.size(), 1U);
}

TEST(ContactShape, IsWhatCollisionSaysInstead) {
  const std::string box = "shape: {box: [1, 1, 1]}, mass: 1, ";
  EXPECT_TRUE(shapeOf(box + "collision: []").empty());
  const ContactShape ball =
      shapeOf(box + "collision: [{shape: {sphere: {radius: 2}}, position: [1, 2, 3]}]");
  EXPECT_TRUE(ball.points.empty());
  ASSERT_EQ(ball.balls.size(), 1U);
  EXPECT_EQ(ball.balls[0].center_P, Vector3d(1, 2, 3));
}

TEST(ContactShape, IsTurnedAndMovedWithItsFrame) {
  const Isometry3d X_PB = isometry(Quaterniond(std::sqrt(0.5), std::sqrt(0.5), 0, 0), {1, 0, 0});
  const ContactShape shape = shapeOf(
      "shape: {sphere: {radius: 1}}, mass: 1, collision: [{shape: {cylinder: {radius: 1, length: "
      "2}}}, {shape: {ellipsoid: [1, 2, 3]}, position: [0, 1, 0]}]",
      X_PB);
  ASSERT_EQ(shape.rims.size(), 2U);  // z has become −y
  EXPECT_LE((shape.rims[1].center_P - Vector3d(1, -1, 0)).norm(), 1e-15);
  EXPECT_LE((shape.rims[1].axis_P - Vector3d(0, -1, 0)).norm(), 1e-15);
  ASSERT_EQ(shape.ellipsoids.size(), 1U);
  EXPECT_LE((shape.ellipsoids[0].center_P - Vector3d(1, 0, 1)).norm(), 1e-15);
  EXPECT_LE((shape.ellipsoids[0].q_PE * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), 1e-15);
}

}  // namespace rigid_body_sim
