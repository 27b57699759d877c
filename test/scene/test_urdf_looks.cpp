#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/urdf/read_urdf.hpp"
#include "scene/urdf/urdf_visual.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A robot of one link with a mass and a box in each <visual>.
class UrdfLooks : public ::testing::Test {
 protected:
  UrdfRobot robotWith(const std::string& materials, const std::string& elements) const {
    return readUrdf(files_.written(
        "r.urdf", "<robot name='r'>" + materials +
                      "<link name='l'><inertial><mass value='2'/><inertia ixx='1' ixy='0' ixz='0' "
                      "iyy='1' iyz='0' izz='1'/></inertial>" +
                      elements + "</link></robot>"));
  }

  static std::string box(const std::string& material) {
    return "<visual><geometry><box size='1 2 3'/></geometry>" + material + "</visual>";
  }

  static std::string color(const std::string& name, const std::string& rgba) {
    return "<material name='" + name + "'><color rgba='" + rgba + "'/></material>";
  }

  TemporaryDirectory files_;
};

struct Torus : urdf::Geometry {};

}  // namespace

TEST_F(UrdfLooks, LoseAColourThatCannotBeReadAndNothingElse) {
  for (const std::string rgba : {"1/2 0.2 0 1", "1 1 1", "", "2 0 0 1", "1,1,1,1", "a b c d"}) {
    const UrdfRobot robot = robotWith(
        color("paint", rgba) + color("good", "0 0.5 1 1"),
        box("<material name='paint'/>") + box("<material name='good'/>") + box(color("own", rgba)));
    ASSERT_THAT(robot.links.at(0).visuals, SizeIs(3)) << rgba;
    EXPECT_EQ(robot.links[0].mass->mass, 2);
    EXPECT_FALSE(robot.links[0].visuals[0].color) << rgba;
    EXPECT_EQ(robot.links[0].visuals[1].color, (Color{0, 0.5, 1, 1}));
    EXPECT_FALSE(robot.links[0].visuals[2].color) << rgba;
    const std::string rule =
        " is left out: its color must be four numbers from 0 to 1, got '" + rgba + "'";
    EXPECT_THAT(robot.notices, ElementsAre("material 'paint'" + rule, "material 'own'" + rule));
  }
}

TEST_F(UrdfLooks, TakeTheFirstOfTwoMaterialsOfOneName) {
  const UrdfRobot robot = robotWith(color("paint", "1 0 0 1") + color("paint", "0 1 0 1"),
                                    box("<material name='paint'/>"));
  EXPECT_EQ(robot.links.at(0).visuals.at(0).color, (Color{1, 0, 0, 1}));
  EXPECT_THAT(robot.notices, ElementsAre("material 'paint' is left out: it is defined before"));
}

TEST_F(UrdfLooks, LoseAVisualThatCannotBeReadAndNothingElse) {
  for (const std::string& wrong :
       {std::string("<visual><geometry><box size='1 2'/></geometry></visual>"),
        std::string("<visual><geometry><torus/></geometry></visual>"),
        std::string("<visual><origin xyz='a b c'/><geometry><sphere radius='1'/></geometry>"
                    "</visual>"),
        std::string("<visual/>"),
        std::string("<collision><geometry><box size='1 2'/></geometry></collision>")}) {
    const UrdfRobot robot = robotWith("", wrong + box(color("good", "0 0.5 1 1")));
    EXPECT_EQ(robot.links.at(0).mass->mass, 2) << wrong;
    ASSERT_THAT(robot.notices, SizeIs(1)) << wrong;
    EXPECT_THAT(robot.notices[0], HasSubstr("left out of what is drawn: "));
    EXPECT_THAT(robot.notices[0], EndsWith("for Link [l]")) << wrong;
  }
}

TEST_F(UrdfLooks, AreNoExcuseForAMassThatCannotBeRead) {
  const std::string path = files_.written(
      "r.urdf",
      "<robot name='r'><link name='l'><visual/><inertial><mass value='2kg'/><inertia "
      "ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link></robot>");
  try {
    readUrdf(path);
    FAIL() << "read";
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), HasSubstr("mass [2kg]"));
  }
}

TEST_F(UrdfLooks, AreReadWithoutNoticeWhereNothingIsWrong) {
  EXPECT_THAT(robotWith(color("paint", "1 0 0 1"), box("<material name='paint'/>")).notices,
              IsEmpty());
}

TEST(UrdfVisual, IsNoneForAGeometryThatIsNotKnown) {
  urdf::Visual visual;
  EXPECT_FALSE(toVisual(visual, ""));
  visual.geometry = std::make_shared<Torus>();
  visual.geometry->type = urdf::Geometry::MESH;  // what an older reader would have taken it for
  EXPECT_FALSE(toVisual(visual, ""));
  visual.geometry = std::make_shared<urdf::Sphere>();
  EXPECT_TRUE(toVisual(visual, ""));
}

}  // namespace rigid_body_sim
