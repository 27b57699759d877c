#include <gtest/gtest.h>

#include "scene/build/body_mass.hpp"
#include "scene/build/visuals_of.hpp"
#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

/// A scene of one body "ground" that has these keys, on line 3.
std::string groundScene(const std::string& keys) {
  return "time_step: 0.01\nbodies:\n  - {name: ground, " + keys + "}\n";
}

std::string groundError(const std::string& keys) { return errorOf(groundScene(keys)); }

const std::string kGround = "s.yaml:3: body 'ground': ";

}  // namespace

TEST(Plane, IsTheShapeOfAFixedBody) {
  const Scene scene = parseScene(groundScene("shape: {plane: {}}, fixed: true, "
                                             "position: [0, 0, 2], orientation: [1, 0, 0, 0]"),
                                 "s.yaml");
  EXPECT_TRUE(std::holds_alternative<PlaneDef>(scene.bodies[0].composition));
  EXPECT_FALSE(hasMass(scene.bodies[0]));
  const World world = buildWorld(scene);
  EXPECT_TRUE(world.bodies[0].fixed);
  const BodyFrameMotion ground =
      toBodyFrameMotion(world.bodies[0], initialState(scene, world).bodies[0]);
  EXPECT_EQ(ground.x_W, Vector3d(0, 0, 2));
  EXPECT_EQ(ground.q_WB.coeffs(), Eigen::Vector4d(1, 0, 0, 0));
}

TEST(Plane, DoesNotMove) {
  const std::string rule =
      kGround + "shape.plane needs fixed: true, for a half-space has no mass and cannot move";
  EXPECT_EQ(groundError("shape: {plane: {}}"), rule);
  EXPECT_EQ(groundError("shape: {plane: {}}, fixed: false"), rule);
  Scene scene = parseScene(groundScene("shape: {plane: {}}, fixed: true"), "s.yaml");
  scene.bodies[0].fixed = false;
  EXPECT_THROW(buildWorld(scene), SceneError);
}

TEST(Plane, HasNoMassKeys) {
  const std::string rule = " cannot stand beside shape.plane, which has no mass, got ";
  const std::string fixed_plane = "shape: {plane: {}}, fixed: true, ";
  EXPECT_EQ(groundError(fixed_plane + "mass: 1"), kGround + "mass" + rule + "1");
  EXPECT_EQ(groundError(fixed_plane + "density: 7"), kGround + "density" + rule + "7");
  EXPECT_EQ(groundError(fixed_plane + "center_of_mass: [0, 0, 0]"),
            kGround + "center_of_mass" + rule + "[0, 0, 0]");
  EXPECT_EQ(groundError(fixed_plane + "collision: []"),
            kGround + "collision cannot stand beside shape.plane, which touches as it is");
}

TEST(Plane, StandsAloneAndHasNoSize) {
  EXPECT_EQ(groundError("shape: {plane: {z: 1}}, fixed: true"),
            kGround +
                "shape.plane must be {}: it is the plane z = 0 of the body frame, got a "
                "mapping");
  EXPECT_EQ(groundError("shape: {plane: 1}, fixed: true"),
            kGround + "shape.plane must be {}: it is the plane z = 0 of the body frame, got 1");
  const std::string rule =
      " must be the only shape of a fixed body: shape: {plane: {}}, fixed: true";
  EXPECT_EQ(groundError("shape: {plane: {}, sphere: {radius: 1}}, fixed: true, mass: 1"),
            kGround + "shape.plane" + rule);
  EXPECT_EQ(groundError("parts: [{shape: {plane: {}}, mass: 1}], fixed: true"),
            kGround + "parts[0].shape.plane" + rule);
}

TEST(Plane, IsDrawnAsASquarePatch) {
  const Scene scene = parseScene(groundScene("shape: {plane: {}}, fixed: true"), "s.yaml");
  const std::vector<Visual> visuals = visualsOf(scene.bodies[0]);
  ASSERT_EQ(visuals.size(), 1U);
  EXPECT_GT(std::get<PatchVisual>(visuals[0].geometry).side, 1);
  EXPECT_TRUE(visuals[0].X_BV.matrix().isIdentity(0));
  const Scene red = parseScene(
      groundScene("shape: {plane: {}}, fixed: true, visual: {color: [1, 0, 0, 1]}"), "s.yaml");
  EXPECT_EQ(visualsOf(red.bodies[0])[0].color, (Color{1, 0, 0, 1}));
}

}  // namespace rigid_body_sim
