#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/scene/frames.hpp>

#include "scene/build/visuals_of.hpp"
#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

BodyDef boxWith(const std::string& more) { return parseScene(boxScene(more), "s.yaml").bodies[0]; }

std::vector<std::string> noticesOf(const std::string& more) {
  return parseScene(boxScene(more), "s.yaml").notices;
}

/// URDF: fixed axes, roll about x, then pitch about y, then yaw about z.
Matrix3d fixedAxes(double roll, double pitch, double yaw) {
  const auto about = [](double angle, int i, int j) {
    Matrix3d R = Matrix3d::Identity();
    R(i, i) = R(j, j) = std::cos(angle);
    R(j, i) = std::sin(angle);
    R(i, j) = -R(j, i);
    return R;
  };
  return about(yaw, 0, 1) * about(pitch, 2, 0) * about(roll, 1, 2);
}

}  // namespace

TEST(SceneOrientation, MayBeRollPitchYawWhereverItStands) {
  const std::string rpy = "orientation: {rpy: [0.4, -0.5, 2.6]}";
  const Matrix3d R = fixedAxes(0.4, -0.5, 2.6);
  const auto differs = [&](const Quaterniond& q) {
    return (q.toRotationMatrix() - R).cwiseAbs().maxCoeff();
  };
  const BodyDef box = boxWith("    " + rpy + "\n    points: {tip: {" + rpy +
                              "}}\n    visual: {mesh: a.stl, " + rpy + "}\n");
  EXPECT_LE(differs(box.orientation), 1e-15);
  EXPECT_LE(differs(box.points[0].orientation), 1e-15);
  EXPECT_LE(differs(box.visual.orientation), 1e-15);
  const Scene parts = parseScene(
      "time_step: 1\nbodies: [{name: a, parts: [{shape: {box: [1, 2, 3]}, mass: 1, " + rpy + "}]}]",
      "s.yaml");
  EXPECT_LE(differs(std::get<std::vector<PartDef>>(parts.bodies[0].composition).at(0).orientation),
            1e-15);
}

TEST(SceneOrientation, KeepsTheRulesOfRollPitchYaw) {
  EXPECT_EQ(errorOf(boxScene("    orientation: {rpy: [0, 0]}\n")),
            kAtBox + "orientation.rpy must be a list of 3 numbers [rad], got [0, 0]");
  EXPECT_EQ(errorOf(boxScene("    orientation: {}\n")), kAtBox + "missing key 'orientation.rpy'");
  EXPECT_EQ(errorOf(boxScene("    orientation: {yaw: 1}\n")),
            kAtBox + "unknown key 'orientation.yaw' (known: rpy)");
}

TEST(SceneFrame, IsTheBodysNameInTf) {
  const Scene scene = parseScene(
      boxScene(
          "    frame: robot/base-link\n    points: {tip: {position: [0, 0, 1]}}\nwrenches:\n"
          "  - {body: box, frame: robot/base-link, force: [1, 0, 0], duration: 1}\n"
          "  - {body: box, frame: box, point_frame: box/tip, force: [1, 0, 0], duration: 1}\n"),
      "s.yaml");
  EXPECT_EQ(frameOf(scene.bodies[0]), "robot/base-link");
  EXPECT_EQ(frameOf(boxWith("")), "box");
  const World world = buildWorld(scene);
  EXPECT_EQ(world.wrenches.at(0).axes, 0U);
  EXPECT_EQ(FrameTable(scene, world.bodies).names(), "world, box, robot/base-link, box/tip");
}

TEST(SceneFrame, KeepsItsRules) {
  for (const std::string name : {"/box", "box/", "a//b", "\"a b\"", "\"\"", "[a]"})
    EXPECT_EQ(errorOf(boxScene("    frame: " + name + "\n")),
              kAtBox +
                  "frame must be a frame name: letters, digits, _, - and ., parts joined by /, at "
                  "most 255 bytes, got " +
                  name);
  EXPECT_EQ(errorOf(boxScene("    frame: world\n")),
            "s.yaml:3: body 'box': frame: 'world' is the world frame's name");
  EXPECT_EQ(
      errorOf(boxScene("    frame: a\n  - {name: a, shape: {sphere: {radius: 1}}, mass: 1}\n")),
      "s.yaml:7: body 'a': name is taken, by the body on line 3");
}

TEST(SceneVisual, IsPlacedAndScaled) {
  const auto visuals = visualsOf(
      boxWith("    visual: {mesh: 'package://p/a.stl', scale: [1, 2, 3], position: [4, 5, "
              "6], orientation: [0, 0, 1, 0]}\n"));
  ASSERT_EQ(visuals.size(), 1U);
  EXPECT_EQ(std::get<MeshVisual>(visuals[0].geometry).scale, Vector3d(1, 2, 3));
  EXPECT_EQ(visuals[0].X_BV.translation(), Vector3d(4, 5, 6));
  EXPECT_EQ(visuals[0].X_BV.linear().col(0), Vector3d(-1, 0, 0));
  const auto millimetres = visualsOf(boxWith("    visual: {mesh: a.stl, scale: 0.001}\n"));
  EXPECT_EQ(std::get<MeshVisual>(millimetres.at(0).geometry).scale, Vector3d(0.001, 0.001, 0.001));
}

TEST(SceneVisual, KeepsItsRules) {
  EXPECT_EQ(errorOf(boxScene("    visual: {scale: 2}\n")),
            kAtBox + "visual.scale goes with visual.mesh, got 2");
  EXPECT_EQ(errorOf(boxScene("    visual: {mesh: a.stl, scale: [1, 0, 1]}\n")),
            kAtBox + "visual.scale[1] must be > 0, got 0");
  EXPECT_EQ(errorOf(boxScene("    visual: {mesh: a.stl, scale: [1, 1]}\n")),
            kAtBox + "visual.scale must be a number or a list of 3 numbers, got [1, 1]");
}

TEST(SceneTwist, TakesTheNamesOfItsFrames) {
  const auto inBody = [](const std::string& frame) {
    return parseScene("world_frame: map\n" + boxScene("    frame: base-link\n    twist: {frame: " +
                                                      frame + ", linear: [1, 0, 0]}\n"),
                      "s.yaml")
        .bodies[0]
        .twist.in_body_axes;
  };
  EXPECT_FALSE(inBody("world"));
  EXPECT_FALSE(inBody("map"));
  EXPECT_TRUE(inBody("body"));
  EXPECT_TRUE(inBody("box"));
  EXPECT_TRUE(inBody("base-link"));
  // also where the world frame is named after the bodies
  EXPECT_EQ(errorOf(boxScene("    twist: {frame: map}\nworld_frame: map\n")), "");
}

TEST(SceneNames, ComeWithTheOneThatMayBeMeant) {
  const std::string wrench = "wrenches:\n  - {body: bix, frame: box, duration: 1}\n";
  EXPECT_EQ(errorOf(boxScene(wrench)),
            "s.yaml:7: wrenches[0]: unknown body 'bix' (known: box); did you mean 'box'?");
  EXPECT_EQ(errorOf(boxScene("    points: {thruster: {}}\nwrenches:\n"
                             "  - {body: box, frame: box/truster, duration: 1}\n")),
            "s.yaml:8: wrenches[0]: unknown frame 'box/truster' (known: world, box, box/thruster); "
            "did you mean 'box/thruster'?");
  EXPECT_EQ(errorOf(boxScene("wrenches:\n  - {body: box, frame: tip, duration: 1}\n")),
            "s.yaml:7: wrenches[0]: unknown frame 'tip' (known: world, box)");
  EXPECT_EQ(errorOf(boxScene("forces:\n  - {type: spring, from: {body: Box}, to: {world: [0, 0, "
                             "2]}, stiffness: 1}\n")),
            "s.yaml:7: forces[0]: from.body must be one of box, got 'Box'; did you mean 'box'?");
}

TEST(SceneNumbers, AreQuestionedWhereTheyLookLikeDegreesOrLikeWFirst) {
  EXPECT_THAT(noticesOf("    twist: {frame: body, angular: [0, 0, 360]}\n"),
              ElementsAre(kAtBox + "twist.angular is 57.3 turns/s; its unit is rad/s"));
  EXPECT_THAT(
      noticesOf("    orientation: [1, 0, 0, 0]\n"),
      ElementsAre(kAtBox + "orientation turns the z axis by 180 degrees; quaternions are [x, "
                           "y, z, w]"));
  EXPECT_THAT(noticesOf("    orientation: [0.7071067811865476, 0, 0, 0.7071067811865476]\n"),
              IsEmpty());
  EXPECT_THAT(noticesOf("    twist: {frame: body, angular: [0, 0, 200]}\n"), IsEmpty());
  EXPECT_THAT(noticesOf("    orientation: [1, 0, 0, 0]\n"
                        "  - {name: b, shape: {sphere: {radius: 1}}, mass: 1, orientation: [1, 0, "
                        "0, 0]}\n"),
              ElementsAre(HasSubstr("(and 1 more)")));
}

}  // namespace rigid_body_sim
