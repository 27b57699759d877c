#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/build/visuals_of.hpp"
#include "scene_texts.hpp"
#include "support/mesh_texts.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::HasSubstr;

const std::string kLaw = "forces:\n  - {type: contact, between: [a, ground], stiffness: 1.0e+5}\n";

/// A scene of a ground and a body "a" with these keys, on line 4.
std::string collisionScene(const std::string& keys, const std::string& forces = kLaw) {
  return "time_step: 0.01\nbodies:\n  - {name: ground, shape: {plane: {}}, fixed: true}\n"
         "  - {name: a, " +
         keys + "}\n" + forces;
}

std::string collisionError(const std::string& keys) {
  return errorOf(collisionScene("shape: {sphere: {radius: 1}}, mass: 1, " + keys));
}

const std::string kBodyA = "s.yaml:4: body 'a': ";

class CollisionFiles : public ::testing::Test {
 protected:
  BodyDef load(const std::string& keys, const std::string& forces = kLaw) const {
    return loadScene(files_.written("s.yaml", collisionScene(keys, forces))).bodies[1];
  }

  std::string error(const std::string& keys) const {
    try {
      load(keys);
    } catch (const SceneError& e) {
      return e.what();
    }
    return "";
  }

  TemporaryDirectory files_;
};

std::string robotOf(const std::string& collision) {
  return "<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' ixy='0' "
         "ixz='0' iyy='1' iyz='0' izz='1'/></inertial><collision>" +
         collision + "</collision></link></robot>";
}

}  // namespace

TEST(Collision, IsAListOfPlacedShapes) {
  const Scene scene = parseScene(
      collisionScene("shape: {sphere: {radius: 1}}, mass: 1, collision: ["
                     "{shape: {box: [1, 2, 3]}, position: [1, 0, 0], orientation: [0, 0, 1, 0]}, "
                     "{shape: {capsule: {radius: 1, length: 2}}}]"),
      "s.yaml");
  const std::vector<CollisionDef>& solids = scene.bodies[1].collision.value();
  ASSERT_EQ(solids.size(), 2U);
  EXPECT_EQ(std::get<Box>(std::get<Shape>(solids[0].geometry)).size, Vector3d(1, 2, 3));
  EXPECT_EQ(solids[0].position, Vector3d(1, 0, 0));
  EXPECT_EQ(solids[0].orientation.z(), 1);
  EXPECT_EQ(std::get<Capsule>(std::get<Shape>(solids[1].geometry)).length, 2);
  EXPECT_EQ(solids[1].position, Vector3d(0, 0, 0));
}

TEST(Collision, HasNoPartInWhatIsDrawn) {
  const Scene scene = parseScene(
      collisionScene(
          "shape: {sphere: {radius: 1}}, mass: 1, collision: [{shape: {box: [1, 2, 3]}}]"),
      "s.yaml");
  EXPECT_TRUE(
      std::holds_alternative<Sphere>(std::get<Shape>(visualsOf(scene.bodies[1]).at(0).geometry)));
}

TEST(Collision, KeepsTheRulesOfItsKeys) {
  EXPECT_EQ(collisionError("collision: {}"),
            kBodyA + "collision must be a list of shapes, each with its place, got a mapping");
  EXPECT_EQ(collisionError("collision: [{position: [0, 0, 0]}]"),
            kBodyA + "missing key 'collision[0].shape'");
  EXPECT_EQ(collisionError("collision: [{shape: {sphere: {radius: 1}}, mass: 1}]"),
            kBodyA + "unknown key 'collision[0].mass' (known: shape, position, orientation)");
  EXPECT_EQ(collisionError("collision: [{shape: {sphere: {radius: -1}}}]"),
            kBodyA + "collision[0].shape.sphere.radius must be > 0 m, got -1");
  EXPECT_EQ(collisionError("collision: [{shape: {plane: {}}}]"),
            kBodyA +
                "collision[0].shape.plane must be the only shape of a fixed body: shape: "
                "{plane: {}}, fixed: true");
}

TEST(Collision, IsDrawnOfABodyOfGivenInertia) {
  const Scene scene =
      parseScene(collisionScene("mass: 1, inertia: {ixx: 1, iyy: 1, izz: 1}, "
                                "collision: [{shape: {sphere: {radius: 2}}, position: [1, 2, 3]}]"),
                 "s.yaml");
  const std::vector<Visual> visuals = visualsOf(scene.bodies[1]);
  ASSERT_EQ(visuals.size(), 1U);
  EXPECT_EQ(std::get<Sphere>(std::get<Shape>(visuals[0].geometry)).radius, 2);
  EXPECT_EQ(visuals[0].X_BV.translation(), Vector3d(1, 2, 3));
}

TEST(Collision, HasAtMost10000Shapes) {
  std::string shapes;
  for (int i = 0; i < 10001; ++i) shapes += "{shape: {sphere: {radius: 1}}}, ";
  EXPECT_EQ(collisionError("collision: [" + shapes + "]"),
            kBodyA + "collision must hold at most 10000 shapes, got 10001");
}

TEST_F(CollisionFiles, OfAMeshAreTheCornersOfItsHull) {
  files_.written("brick.obj", kBrickOfQuads);
  const BodyDef body = load("shape: {mesh: {file: brick.obj}}, density: 1");
  const auto& mesh = std::get<MeshDef>(std::get<SolidDef>(body.composition).geometry);
  ASSERT_TRUE(mesh.corners);
  EXPECT_EQ(mesh.corners->size(), 8U);
  EXPECT_THAT(*mesh.corners, ::testing::Contains(Vector3d(1.5, -0.5, -1.25)));
}

TEST_F(CollisionFiles, AreNotComputedInASceneWithoutContact) {
  files_.written("brick.obj", kBrickOfQuads);
  const BodyDef body = load("shape: {mesh: {file: brick.obj}}, density: 1", "");
  EXPECT_FALSE(std::get<MeshDef>(std::get<SolidDef>(body.composition).geometry).corners);
}

TEST_F(CollisionFiles, MayHaveOpenSurfaces) {
  std::string open = kBrickOfQuads;
  open.erase(open.rfind("f "));
  files_.written("open.obj", open);
  const BodyDef body = load(
      "shape: {sphere: {radius: 1}}, mass: 1, collision: [{shape: {mesh: {file: open.obj, scale: "
      "2}}}]");
  const HullCorners& corners = std::get<HullDef>(body.collision.value().at(0).geometry).corners;
  EXPECT_EQ(corners->size(), 8U);
  EXPECT_THAT(*corners, ::testing::Contains(Vector3d(3, -1, -2.5)));
}

TEST_F(CollisionFiles, ThatCannotBeReadAreNamed) {
  EXPECT_EQ(
      error("shape: {sphere: {radius: 1}}, mass: 1, collision: [{shape: {mesh: {file: no.stl}}}]"),
      files_.path("s.yaml") + ":4: body 'a': collision[0].shape.mesh.file: " +
          files_.path("no.stl") + ": mesh file does not exist");
}

TEST_F(CollisionFiles, OfAUrdfLinkAreItsCollisionElements) {
  files_.written("brick.obj", kBrickOfQuads);
  files_.written(
      "r.urdf",
      robotOf("<origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/>"
              "<geometry><cylinder radius='2' length='5'/></geometry></collision>"
              "<collision><geometry><mesh filename='brick.obj' scale='1 1 -1'/></geometry>"));
  const BodyDef body = load("urdf: {file: r.urdf}");
  const std::vector<CollisionDef>& solids = std::get<LinkDef>(body.composition).collision;
  ASSERT_EQ(solids.size(), 2U);
  EXPECT_EQ(std::get<Cylinder>(std::get<Shape>(solids[0].geometry)).length, 5);
  EXPECT_EQ(solids[0].position, Vector3d(1, 2, 3));
  EXPECT_LE((solids[0].orientation * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_THAT(*std::get<HullDef>(solids[1].geometry).corners,
              ::testing::Contains(Vector3d(1.5, -0.5, 1.25)));

  EXPECT_TRUE(std::get<LinkDef>(load("urdf: {file: r.urdf}", "").composition).collision.empty());
  const BodyDef chosen = load("urdf: {file: r.urdf}, collision: []");
  EXPECT_TRUE(std::get<LinkDef>(chosen.composition).collision.empty());
}

TEST_F(CollisionFiles, OfAUrdfLinkAreNotLeftOutInSilence) {
  const std::string start = files_.path("s.yaml") + ":4: body 'a': urdf: " + files_.path("r.urdf") +
                            ": link 'base': <collision>: ";
  const std::string end = " (a scene may say what touches: collision, a key of the body)";
  files_.written("r.urdf", robotOf("<geometry><box size='1 0 1'/></geometry>"));
  EXPECT_EQ(error("urdf: {file: r.urdf}"),
            start + "its lengths must be finite and > 0 m, got [1, 0, 1]" + end);
  EXPECT_EQ(error("urdf: {file: r.urdf}, collision: []"), "");
  files_.written("r.urdf", robotOf("<geometry><mesh filename='no.stl'/></geometry>"));
  EXPECT_EQ(error("urdf: {file: r.urdf}"),
            start + "mesh 'no.stl': " + files_.path("no.stl") + ": mesh file does not exist" + end);
  files_.written("r.urdf", robotOf("<geometry><mesh filename='package://p/no.stl'/></geometry>"));
  EXPECT_EQ(error("urdf: {file: r.urdf}"),
            start +
                "mesh 'package://p/no.stl': must be a path: this program cannot look up ROS "
                "packages" +
                end);
  files_.written("r.urdf", robotOf("<geometry><blob/></geometry>"));
  EXPECT_THAT(error("urdf: {file: r.urdf}"),
              HasSubstr("<collision> or <visual> elements cannot be read: "));
}

}  // namespace rigid_body_sim
