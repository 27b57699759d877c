#include <gtest/gtest.h>

#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

std::string timeStepError(const std::string& value) {
  return errorOf("time_step: " + value + "\nbodies: []\n");
}

/// Body "a" of given properties: mass on line 4, inertia on line 5.
std::string massError(const std::string& mass, const std::string& inertia) {
  return errorOf("time_step: 0.01\nbodies:\n  - name: a\n    mass: " + mass +
                 "\n    inertia: " + inertia + "\n");
}

std::string wrenchError(const std::string& more) {
  return boxError("wrenches:\n  - {body: box, frame: box, " + more + "}\n");
}

const std::string kWrench = "s.yaml:7: wrenches[0]: ";
const std::string kUnitInertia = "{ixx: 1, iyy: 1, izz: 1}";

}  // namespace

TEST(SceneNumbers, AreDecimalAndNothingElse) {
  for (const std::string value : {"1.0abc", "abc", "0x10", "1,5", "1_000", "1 2", "e5", "1e", ".",
                                  "+", "\"1\"", "true", "inf", "nan", "--1", "1e5.0", "1d3"}) {
    EXPECT_EQ(timeStepError(value), "s.yaml:1: time_step must be a number [s], got " + value);
  }
  EXPECT_EQ(timeStepError("~"), "s.yaml:1: time_step must be a number [s], got nothing");
  EXPECT_EQ(timeStepError(""), "s.yaml:1: time_step must be a number [s], got nothing");
  EXPECT_EQ(timeStepError("[1]"), "s.yaml:1: time_step must be a number [s], got [1]");
  EXPECT_EQ(timeStepError("{a: 1}"), "s.yaml:1: time_step must be a number [s], got a mapping");
}

TEST(SceneNumbers, AreFinite) {
  for (const std::string value : {".nan", ".NaN", ".inf", "-.inf", "+.Inf", "1e400", "-1e400"}) {
    EXPECT_EQ(timeStepError(value),
              "s.yaml:1: time_step must be a finite number [s], got " + value);
  }
  EXPECT_EQ(boxError("    position: [0, .nan, 0]\n"),
            kAtBox + "position[1] must be a finite number [m], got .nan");
}

TEST(SceneNumbers, ArePositiveWhereTheyMustBe) {
  EXPECT_EQ(timeStepError("0"), "s.yaml:1: time_step must be > 0 s, got 0");
  EXPECT_EQ(timeStepError("1e-400"), "s.yaml:1: time_step must be > 0 s, got 1e-400");
  EXPECT_EQ(errorOf("tolerance: -1e-9\n" + boxScene()),
            "s.yaml:1: tolerance must be > 0, got -1e-9");
  EXPECT_EQ(errorOf("horizon: 0\n" + boxScene()), "s.yaml:1: horizon must be > 0 s, got 0");
  EXPECT_EQ(massError("-1", kUnitInertia), "s.yaml:4: body 'a': mass must be > 0 kg, got -1");
  EXPECT_EQ(massError("0", kUnitInertia), "s.yaml:4: body 'a': mass must be > 0 kg, got 0");
  const std::string body = "time_step: 1\nbodies:\n  - name: a\n";
  EXPECT_EQ(errorOf(body + "    density: -2\n"),
            "s.yaml:4: body 'a': density must be > 0 kg/m^3, got -2");
  EXPECT_EQ(errorOf(body + "    shape: {box: [1, 0, 1]}\n"),
            "s.yaml:4: body 'a': shape.box[1] must be > 0 m, got 0");
  EXPECT_EQ(errorOf(body + "    shape: {sphere: {radius: -1}}\n"),
            "s.yaml:4: body 'a': shape.sphere.radius must be > 0 m, got -1");
  EXPECT_EQ(errorOf(body + "    shape: {capsule: {radius: 1, length: -1}}\n"),
            "s.yaml:4: body 'a': shape.capsule.length must be >= 0 m, got -1");
}

TEST(SceneInertia, IsThatOfARigidBody) {
  EXPECT_EQ(massError("1", "{ixx: 1, iyy: 1, izz: 5}"),
            "s.yaml:5: body 'a': inertia must satisfy the triangle inequality I1 + I2 >= I3, got "
            "principal moments [1, 1, 5] kg m^2: 2 < 5 (impossible_inertia: balance raises the "
            "moments to meet it)");
  EXPECT_EQ(massError("1", "{ixx: 1, iyy: 1, izz: -1}"),
            "s.yaml:5: body 'a': inertia must be positive definite, got principal moments "
            "[-1, 1, 1] kg m^2");
  EXPECT_EQ(massError("1", "{ixx: 1, iyy: 2, izz: 3}"), "");  // a flat plate
  EXPECT_EQ(massError("1", "{ixx: 1, iyy: 1}"), "s.yaml:5: body 'a': missing key 'inertia.izz'");
  EXPECT_EQ(massError("1", "[1, 1, 1]"),
            "s.yaml:5: body 'a': inertia must be a mapping, got [1, 1, 1] (keys: ixx, iyy, izz, "
            "ixy, ixz, iyz)");
}

TEST(SceneMass, MustFitIntoADouble) {
  EXPECT_EQ(errorOf("time_step: 1\nbodies:\n  - name: a\n    shape: {box: [1e200, 1e200, 1]}\n"
                    "    density: 1\n"),
            "s.yaml:4: body 'a': mass must be a finite number of kg, got inf");
}

TEST(SceneMass, HasAnInverse) {
  EXPECT_EQ(
      massError("5.0e-309", kUnitInertia)
          .rfind("s.yaml:5: body 'a': mass must be so large that 1/mass is a finite number, got ",
                 0),
      0U)
      << massError("5.0e-309", kUnitInertia);
}

TEST(SceneLists, HaveTheirLength) {
  EXPECT_EQ(boxError("    position: [1, 2]\n"),
            kAtBox + "position must be a list of 3 numbers [m], got [1, 2]");
  EXPECT_EQ(boxError("    position: 1\n"),
            kAtBox + "position must be a list of 3 numbers [m], got 1");
  EXPECT_EQ(errorOf("gravity:\n" + boxScene()),
            "s.yaml:1: gravity must be a list of 3 numbers [m/s^2], got nothing");
  EXPECT_EQ(boxError("    orientation: [0, 0, 1]\n"),
            kAtBox + "orientation must be a list of 4 numbers, got [0, 0, 1]");
  EXPECT_EQ(boxError("    twist: {frame: body, linear: [a, 0, 0]}\n"),
            kAtBox + "twist.linear[0] must be a number [m/s], got a");
  EXPECT_EQ(errorOf("time_step: 1\nbodies: []\n"),
            "s.yaml:2: bodies must be a list of at least one body, got []");
  EXPECT_EQ(errorOf("time_step: 1\nbodies: [7]\n"),
            "s.yaml:2: bodies[0]: a mapping is expected, got 7");
  EXPECT_EQ(boxError("wrenches: 3\n"), "s.yaml:6: wrenches must be a list of wrenches, got 3");
}

TEST(SceneValues, KeepTheirOtherRules) {
  EXPECT_EQ(boxError("    orientation: [0, 0, 0, 1.002]\n"),
            kAtBox +
                "orientation must be a unit quaternion [x, y, z, w], its norm within 1e-3 of 1, "
                "got [0, 0, 0, 1.002] of norm 1.002");
  EXPECT_EQ(boxError("    orientation: [0, 0, 0, 0]\n"),
            kAtBox +
                "orientation must be a unit quaternion [x, y, z, w], its norm within 1e-3 of 1, "
                "got [0, 0, 0, 0] of norm 0");
  // off by 1e-3 and no more, on either side
  EXPECT_EQ(boxError("    orientation: [0, 0, 0, 0.999]\n"), "");
  EXPECT_EQ(boxError("    orientation: [0, 0, 0, 1.001]\n"), "");
  EXPECT_NE(boxError("    orientation: [0, 0, 0, 0.9989999]\n"), "");
  EXPECT_NE(boxError("    orientation: [0, 0, 0, 1.0010001]\n"), "");
  EXPECT_EQ(boxError("    twist: {frame: map}\n"),
            kAtBox + "twist.frame must be world or body, got map");
  for (const std::string value : {"yes", "True", "1", "\"true\""})
    EXPECT_EQ(boxError("    fixed: " + value + "\n"),
              kAtBox + "fixed must be true or false, got " + value);
  EXPECT_EQ(boxError("    fixed: true\n    twist: {frame: world, linear: [1, 0, 0]}\n"),
            "s.yaml:7: body 'box': twist must be zero, for the body is fixed, got [1, 0, 0] m/s, "
            "[0, 0, 0] rad/s");
  EXPECT_EQ(boxError("    visual: {color: [1, 0, 0, 1.5]}\n"),
            kAtBox + "visual.color must be [r, g, b, a], each 0 to 1, got [1, 0, 0, 1.5]");
  EXPECT_EQ(boxError("    visual: {mesh: \"\"}\n"),
            kAtBox + "visual.mesh must be a text, got \"\"");
  EXPECT_EQ(boxError("    points: [a]\n"),
            kAtBox + "points must be a mapping of names to frames, got [a]");
}

TEST(SceneWrench, IsWithinNumbersAsAWhole) {
  EXPECT_EQ(wrenchError("duration: 1, force: [0, 0, 1.0e+160], point: [0, 1.0e+160, 0]"),
            kWrench + "the torque of the force must be finite, got 1e+160 N at 1e+160 m");
  EXPECT_EQ(wrenchError("duration: 1, torque: [1.7e+308, 1.7e+308, 0]"),
            kWrench + "torque must have a finite magnitude");
  EXPECT_EQ(wrenchError("duration: 1, force: [0, 0, 1.0e+160], point: [0, 1.0e+100, 0]"), "");
}

TEST(SceneWrench, KeepsItsRules) {
  EXPECT_EQ(wrenchError("duration: 0"), kWrench + "duration must be > 0 s, got 0");
  EXPECT_EQ(wrenchError("duration: -1"), kWrench + "duration must be > 0 s, got -1");
  EXPECT_EQ(wrenchError("duration: .nan"), kWrench + "duration must be > 0 s, got .nan");
  EXPECT_EQ(wrenchError("duration: long"), kWrench + "duration must be a number [s], got long");
  EXPECT_EQ(wrenchError("duration: 1, start: -1"), kWrench + "start must be >= 0 s, got -1");
  EXPECT_EQ(wrenchError("duration: 1, start: .inf"),
            kWrench + "start must be a finite number [s], got .inf");
  EXPECT_EQ(wrenchError("duration: 1, force: [1, 2]"),
            kWrench + "force must be a list of 3 numbers [N], got [1, 2]");
  EXPECT_EQ(wrenchError("duration: 1, point_frame: [a]"),
            kWrench + "point_frame must be a text, got [a]");
}

}  // namespace rigid_body_sim
