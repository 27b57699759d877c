#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/math/isometry.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/frames.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/build/body_mass.hpp"
#include "scene/build/visuals_of.hpp"
#include "support/mass_difference.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

std::string inertial(const std::string& mass, const std::string& moments) {
  return "<inertial><mass value='" + mass + "'/><inertia " + moments +
         " ixy='0' ixz='0' iyz='0'/></inertial>";
}

std::string link(const std::string& name, const std::string& elements) {
  return "<link name='" + name + "'>" + elements + "</link>";
}

std::string joint(const std::string& parent, const std::string& child, const std::string& origin,
                  const std::string& type = "fixed") {
  return "<joint name='to_" + child + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><origin " + origin + "/></joint>";
}

/// A frame without mass; on it a body, turned a quarter about z, and on that a sensor, tilted a
/// quarter about x; a wheel that turns.
std::string craft() {
  return "<robot name='craft'>" + link("frame", "") +
         link("hull", inertial("2", "ixx='3' iyy='4' izz='5'") +
                          "<visual><origin xyz='1 0 0'/><geometry><box size='1 2 3'/></geometry>"
                          "</visual>") +
         link("sensor", inertial("1", "ixx='0.1' iyy='0.2' izz='0.25'") +
                            "<visual><geometry><mesh filename='s.stl'/></geometry></visual>") +
         link("wheel", inertial("7", "ixx='1' iyy='1' izz='1'")) +
         joint("frame", "hull", "xyz='0 0 0.5' rpy='0 0 1.5707963267948966'") +
         joint("hull", "sensor", "xyz='3 0 0' rpy='1.5707963267948966 0 0'") +
         joint("hull", "wheel", "xyz='1 0 0'", "continuous") + "</robot>";
}

/// hull and sensor by hand, in the frame of the root: the hull at (0, 0, 0.5), its x axis along y;
/// the sensor at (0, 3, 0.5), its y axis up and its z axis along x.
MassProperties hullAndSensor() {
  // centre of mass at (0, 1, 0.5): the hull 1 m from it, the sensor 2 m, both along y
  const double steiner = 2 * 1 * 1 + 1 * 2 * 2;
  const Matrix3d I = Vector3d(4 + 0.25 + steiner, 3 + 0.1, 5 + 0.2 + steiner).asDiagonal();
  return {3, Vector3d(0, 1, 0.5), I};
}

class FixedJoints : public ::testing::Test {
 protected:
  Scene sceneOf(const std::string& xml, const std::string& urdf,
                const std::string& more = "") const {
    files_.written("r.urdf", xml);
    return loadScene(files_.written(
        "s.yaml", "time_step: 0.01\nbodies:\n  - name: a\n    urdf: " + urdf + "\n" + more));
  }

  std::string error(const std::string& xml, const std::string& urdf,
                    const std::string& more = "") const {
    try {
      sceneOf(xml, urdf, more);
    } catch (const SceneError& e) {
      return e.what();
    }
    return "loaded";
  }

  static std::vector<std::string> pointsOf(const BodyDef& body) {
    std::vector<std::string> names;
    for (const PointDef& point : body.points) names.push_back(point.name);
    return names;
  }

  TemporaryDirectory files_;
};

}  // namespace

TEST_F(FixedJoints, MakeOneBodyOfTheRootAndWhatHangsOnIt) {
  const BodyDef body = sceneOf(craft(), "{file: r.urdf}").bodies[0];
  EXPECT_TRUE(sameMass(massProperties(body), hullAndSensor(), 4e-15));
  EXPECT_THAT(pointsOf(body), ElementsAre("frame", "hull", "sensor"));
}

TEST_F(FixedJoints, MakeOneBodyFromAnyLinkOn) {
  // the same, seen from the hull
  const Isometry3d X_FH =
      isometry(Quaterniond(Eigen::AngleAxisd(1.5707963267948966, Vector3d::UnitZ())), {0, 0, 0.5});
  const BodyDef body = sceneOf(craft(), "{file: r.urdf, link: hull}").bodies[0];
  EXPECT_TRUE(sameMass(massProperties(body), transformed(X_FH.inverse(), hullAndSensor()), 4e-15));
  EXPECT_THAT(pointsOf(body), ElementsAre("hull", "sensor"));
}

TEST_F(FixedJoints, MayBeLeftAlone) {
  const BodyDef body =
      sceneOf(craft(), "{file: r.urdf, link: hull, fixed_joints: false}").bodies[0];
  EXPECT_TRUE(
      sameMass(massProperties(body), {2, Vector3d::Zero(), Vector3d(3, 4, 5).asDiagonal()}, 0));
  EXPECT_TRUE(body.points.empty());
  EXPECT_EQ(visualsOf(body).size(), 1U);
}

TEST_F(FixedJoints, PlaceWhatIsDrawn) {
  const auto visuals = visualsOf(sceneOf(craft(), "{file: r.urdf}").bodies[0]);
  ASSERT_EQ(visuals.size(), 2U);
  EXPECT_LE((visuals[0].X_BV.translation() - Vector3d(0, 1, 0.5)).norm(), 1e-15);
  EXPECT_LE((visuals[0].X_BV.linear().col(0) - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LE((visuals[1].X_BV.translation() - Vector3d(0, 3, 0.5)).norm(), 1e-15);
  EXPECT_LE((visuals[1].X_BV.linear().col(1) - Vector3d::UnitZ()).norm(), 1e-15);
  EXPECT_LE((visuals[1].X_BV.linear().col(2) - Vector3d::UnitX()).norm(), 1e-15);
}

TEST_F(FixedJoints, NameFramesForWrenches) {
  const Scene scene = sceneOf(craft(), "{file: r.urdf}",
                              "wrenches:\n  - {body: a, frame: a/sensor, point_frame: a/sensor, "
                              "force: [0, 0, 2], duration: 1}\n");
  const World world = buildWorld(scene);
  const BodyState state = initialState(scene, world).bodies[0];
  // along the body's x at (0, 3, 0.5): 2 m beside the centre of mass
  const PointWrench& wrench = world.wrenches.at(0);
  EXPECT_LE((rotate(state.q_WP, wrench.force) - Vector3d(2, 0, 0)).norm(), 1e-14);
  EXPECT_LE((state.x_W + rotate(state.q_WP, wrench.point) - Vector3d(0, 3, 0.5)).norm(), 1e-14);
}

TEST_F(FixedJoints, AcceptNamesThatTfAccepts) {
  const std::string xml = "<robot name='r'>" + link("r/base-link", "") +
                          link("two words", inertial("1", "ixx='1' iyy='1' izz='1'")) +
                          joint("r/base-link", "two words", "xyz='0 0 1'") + "</robot>";
  const Scene scene = sceneOf(xml, "{file: r.urdf}");
  EXPECT_THAT(pointsOf(scene.bodies[0]), ElementsAre("r/base-link"));
  ASSERT_EQ(scene.notices.size(), 1U);
  EXPECT_THAT(scene.notices[0], HasSubstr(":4: body 'a': urdf: link 'two words' becomes no frame"));
}

TEST_F(FixedJoints, LeavePointsOfTheSceneTheirNames) {
  EXPECT_THAT(error(craft(), "{file: r.urdf}", "    points: {sensor: {}}\n"),
              EndsWith("s.yaml:4: body 'a': points.sensor: name is taken, by the point on line 5"));
}

TEST_F(FixedJoints, CountFramesWithoutMassAndPointMasses) {
  const std::string xml =
      "<robot name='r'>" + link("base", inertial("0", "ixx='0' iyy='0' izz='0'")) +
      link("body", inertial("2", "ixx='1' iyy='1' izz='1'")) +
      link("bob", inertial("2", "ixx='0' iyy='0' izz='0'")) + joint("base", "body", "xyz='0 0 0'") +
      joint("body", "bob", "xyz='0 0 2'") + "</robot>";
  // the bob and the body, each 1 m from the common centre
  EXPECT_TRUE(sameMass(massProperties(sceneOf(xml, "{file: r.urdf}").bodies[0]),
                       {4, Vector3d(0, 0, 1), Vector3d(5, 5, 1).asDiagonal()}, 1e-15));
}

TEST_F(FixedJoints, NameTheLinkWhoseInertiaIsImpossible) {
  const std::string xml = "<robot name='r'>" +
                          link("base", inertial("2", "ixx='1' iyy='1' izz='1'")) +
                          link("finger", inertial("1", "ixx='1' iyy='1' izz='4'")) +
                          joint("base", "finger", "xyz='0 0 0'") + "</robot>";
  EXPECT_THAT(error(xml, "{file: r.urdf}"),
              EndsWith(":4: body 'a': urdf: link 'finger': inertia must satisfy the triangle "
                       "inequality I1 + I2 >= I3, got principal moments [1, 1, 4] kg m^2: 2 < 4 "
                       "(impossible_inertia: balance raises the moments to meet it)"));
  const Scene scene = sceneOf(xml, "{file: r.urdf}", "    impossible_inertia: balance\n");
  EXPECT_TRUE(sameMass(massProperties(scene.bodies[0]),
                       {3, Vector3d::Zero(), Vector3d(4, 4, 7).asDiagonal()}, 1e-15));
  ASSERT_EQ(scene.notices.size(), 1U);
  EXPECT_THAT(scene.notices[0], HasSubstr("link 'finger': principal moments [1, 1, 4] kg m^2"));
}

TEST_F(FixedJoints, NeedAMassSomewhere) {
  const std::string xml = "<robot name='r'>" + link("base", "") + link("tip", "") +
                          joint("base", "tip", "xyz='0 0 0'") + "</robot>";
  const std::string path = files_.path("r.urdf");
  EXPECT_THAT(error(xml, "{file: r.urdf}"),
              EndsWith("urdf: the root 'base' must have an <inertial>, itself or a link fixed to "
                       "it, in " +
                       path));
  EXPECT_THAT(error(xml, "{file: r.urdf, link: base}"),
              EndsWith("urdf.link must have an <inertial>, itself or a link fixed to it, in " +
                       path + ", got base"));
}

TEST_F(FixedJoints, FormATree) {
  const std::string links =
      link("o", inertial("1", "ixx='1' iyy='1' izz='1'")) + link("a", "") + link("b", "");
  EXPECT_THAT(error("<robot name='r'>" + links + joint("a", "b", "xyz='0 0 0'") +
                        joint("b", "a", "xyz='0 0 0'") + "</robot>",
                    "{file: r.urdf}"),
              EndsWith("the links must form a tree, but some hang on one another in a circle"));
  EXPECT_THAT(error("<robot name='r'>" + links + joint("o", "a", "xyz='0 0 0'") +
                        joint("o", "b", "xyz='0 0 0'") +
                        "<joint name='again' type='fixed'><parent link='a'/><child link='b'/>"
                        "</joint></robot>",
                    "{file: r.urdf}"),
              EndsWith("the links must form a tree, but 'b' is the child of two joints"));
}

TEST_F(FixedJoints, AreRefusedInAChainTooLong) {
  const auto chain = [](int length) {
    std::string links = link("l0", inertial("1", "ixx='1' iyy='1' izz='1'"));
    for (int i = 1; i < length; ++i)
      links += link("l" + std::to_string(i), "") +
               joint("l" + std::to_string(i - 1), "l" + std::to_string(i), "xyz='0 0 1e-3'");
    return "<robot name='r'>" + links + "</robot>";
  };
  EXPECT_EQ(sceneOf(chain(10000), "{file: r.urdf}").bodies[0].points.size(), 10000U);
  EXPECT_THAT(error(chain(10001), "{file: r.urdf}"),
              EndsWith("must hold at most 10000 links, got 10001"));
}

}  // namespace rigid_body_sim
