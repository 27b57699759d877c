#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/build/body_mass.hpp"
#include "scene/build/inertia_rules.hpp"
#include "scene_texts.hpp"
#include "support/mass_difference.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::ElementsAre;

/// A body of the moments of drone models in wide use, from line 4.
std::string drone(const std::string& more) {
  return "time_step: 0.01\nbodies:\n  - name: a\n    mass: 1.5\n"
         "    inertia: {ixx: 0.0347563, iyy: 0.0458929, izz: 0.0977}\n" +
         more;
}

const std::string kRule =
    "inertia must satisfy the triangle inequality I1 + I2 >= I3, got principal moments [0.0347563, "
    "0.0458929, 0.0977] kg m^2: 0.0806492 < 0.0977 (impossible_inertia: balance raises the moments "
    "to meet it)";

}  // namespace

TEST(ImpossibleInertia, IsRefusedWithAWayOn) {
  EXPECT_EQ(errorOf(drone("")), "s.yaml:5: body 'a': " + kRule);
  EXPECT_EQ(errorOf(drone("    impossible_inertia: refuse\n")), "s.yaml:5: body 'a': " + kRule);
  EXPECT_EQ(
      errorOf("time_step: 0.01\nbodies:\n  - name: a\n    parts:\n"
              "      - {shape: {sphere: {radius: 1}}, mass: 1}\n"
              "      - {mass: 1.5, inertia: {ixx: 0.0347563, iyy: 0.0458929, izz: 0.0977}}\n"),
      "s.yaml:6: body 'a': parts[1]: " + kRule);
}

TEST(ImpossibleInertia, IsBalancedWhereTheSceneSaysSo) {
  const Scene scene = parseScene(drone("    impossible_inertia: balance\n"), "s.yaml");
  // raised by 0.0977 - 0.0347563 - 0.0458929 = 0.0170508 each
  EXPECT_TRUE(sameMass(
      massProperties(scene.bodies[0]),
      {1.5, Vector3d::Zero(), Vector3d(0.0518071, 0.0629437, 0.1147508).asDiagonal()}, 1e-15));
  EXPECT_THAT(scene.notices,
              ElementsAre("s.yaml:5: body 'a': inertia: principal moments [0.0347563, 0.0458929, "
                          "0.0977] kg m^2 break I1 + I2 >= I3: raised by 0.0170508 to [0.0518071, "
                          "0.0629437, 0.114751]"));
  EXPECT_EQ(errorOf(drone("    impossible_inertia: balance\n")), "");
}

TEST(ImpossibleInertia, IsBalancedInTiltedAxesAndInParts) {
  // moments 1, 1, 4, the axis of 4 along (1, 1, 0)
  const Scene scene = parseScene(
      "time_step: 0.01\nbodies:\n  - name: a\n    impossible_inertia: balance\n    parts:\n"
      "      - {mass: 2, inertia: {ixx: 2.5, iyy: 2.5, izz: 1, ixy: 1.5}}\n",
      "s.yaml");
  Matrix3d I;
  I << 4.5, 1.5, 0,  //
      1.5, 4.5, 0,   //
      0, 0, 3;
  EXPECT_TRUE(sameMass(massProperties(scene.bodies[0]), {2, Vector3d::Zero(), I}, 1e-14));
  EXPECT_EQ(scene.notices.size(), 1U);
}

TEST(ImpossibleInertia, LeavesWhatIsPossibleAsItIs) {
  const Scene scene = parseScene(
      "time_step: 0.01\nbodies:\n  - {name: a, mass: 1, impossible_inertia: balance,\n"
      "     inertia: {ixx: 0.1, iyy: 0.2, izz: 0.3}}\n",
      "s.yaml");
  EXPECT_TRUE(scene.notices.empty());
  EXPECT_TRUE(sameMass(massProperties(scene.bodies[0]),
                       {1, Vector3d::Zero(), Vector3d(0.1, 0.2, 0.3).asDiagonal()}, 0));
}

TEST(ImpossibleInertia, MendsNoOtherRule) {
  EXPECT_EQ(
      errorOf("time_step: 0.01\nbodies:\n  - {name: a, mass: 1, impossible_inertia: balance,\n"
              "     inertia: {ixx: 1, iyy: 1, izz: -1}}\n"),
      "s.yaml:4: body 'a': inertia must be positive definite, got principal moments "
      "[-1, 1, 1] kg m^2");
}

TEST(ImpossibleInertia, KeepsTheRulesOfItsKey) {
  EXPECT_EQ(errorOf(drone("    impossible_inertia: yes\n")),
            "s.yaml:6: body 'a': impossible_inertia must be refuse or balance, got yes");
  EXPECT_EQ(errorOf(boxScene("    impossible_inertia: balance\n")),
            "s.yaml:6: body 'box': impossible_inertia goes with inertia, parts or urdf, got "
            "balance");
}

TEST(PartMassFault, AllowsWhatHasNoExtent) {
  const auto part = [](double mass, const Vector3d& moments) {
    return MassProperties{mass, Vector3d::Zero(), moments.asDiagonal()};
  };
  EXPECT_EQ(partMassFault(part(0, {0, 0, 0})), "");
  EXPECT_EQ(partMassFault(part(1, {0, 0, 0})), "");
  EXPECT_EQ(partMassFault(part(1, {0, 2, 2})), "");
  EXPECT_EQ(partMassFault(part(1, {1, 2, 3})), "");
  EXPECT_NE(partMassFault(part(-1, {1, 1, 1})), "");
  EXPECT_NE(partMassFault(part(0, {1, 1, 1})), "");
  EXPECT_NE(partMassFault(part(1, {0, 1, 2})), "");
  EXPECT_NE(partMassFault(part(1, {-1e-6, 1, 1})), "");
  EXPECT_NE(partMassFault(part(1, {1, 1, std::numeric_limits<double>::quiet_NaN()})), "");
  EXPECT_NE(partMassFault(part(std::numeric_limits<double>::infinity(), {1, 1, 1})), "");
}

}  // namespace rigid_body_sim
