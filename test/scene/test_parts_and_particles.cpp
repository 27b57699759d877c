#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "scene/build/body_mass.hpp"
#include "scene_texts.hpp"
#include "support/mass_difference.hpp"

namespace rigid_body_sim {
namespace {

/// The body "a" whose entry goes on with the given lines, from line 4.
std::string bodyText(const std::string& lines) {
  return "time_step: 0.01\nbodies:\n  - name: a\n" + lines;
}

MassProperties massOf(const std::string& lines) {
  return massProperties(parseScene(bodyText(lines), "s.yaml").bodies[0]);
}

std::string partError(const std::string& part) {
  return errorOf(bodyText("    parts: [" + part + "]\n"));
}

const std::string kAtParts = "s.yaml:4: body 'a': ";
const std::string kTriangle =
    "[{mass: 1, position: [0, 0, 0]}, {mass: 2, position: [3, 0, 0]}, "
    "{mass: 3, position: [0, 4, 1]}]";

}  // namespace

TEST(SceneParts, SumToTheWhole) {
  // two cubes side by side are the box they fill; a few roundings of numbers near one
  EXPECT_TRUE(sameMass(massOf("    parts:\n"
                              "      - {shape: {box: [1, 1, 1]}, mass: 2, position: [0.5, 0, 0]}\n"
                              "      - {shape: {box: [1, 1, 1]}, density: 2, position: [1.5, 0, "
                              "0]}\n"),
                       {4, Vector3d(1, 0, 0), massProperties(Box{{2, 1, 1}}, 4).I_Bcm}, 4e-16));
}

TEST(SceneParts, AreTurnedAndPlacedEach) {
  const Quaterniond q = Quaterniond(0.5, 0.1, -0.7, 0.3).normalized();
  Isometry3d X = Isometry3d::Identity();
  X.linear() = q.toRotationMatrix();
  X.translation() = Vector3d(1, -2, 3);
  const std::vector<MassProperties> placed = {
      massProperties(Capsule{0.5, 2}, 3),
      transformed(X, massProperties(Cone{1, 2}, 5 * volume(Cone{1, 2})))};
  // the quaternion is normalised once more on reading
  EXPECT_TRUE(sameMass(massOf("    parts:\n"
                              "      - {shape: {capsule: {radius: 0.5, length: 2}}, mass: 3}\n"
                              "      - shape: {cone: {radius: 1, length: 2}}\n"
                              "        density: 5\n"
                              "        position: [1, -2, 3]\n"
                              "        orientation: [0.109108945117996, -0.763762615825973, "
                              "0.327326835353989, 0.545544725589981]\n"),
                       combined(placed), 4e-15));
}

TEST(SceneParts, MayGiveTheirMassPropertiesInPlaceOfAShape) {
  // a quarter turn about z: the part's x axis is the body's y
  const MassProperties whole = massOf(
      "    parts:\n"
      "      - {mass: 2, inertia: {ixx: 3, iyy: 4, izz: 5, ixy: 0.5}, center_of_mass: [1, 0, 0],\n"
      "         position: [0, 1, 0],\n"
      "         orientation: [0, 0, 0.7071067811865476, 0.7071067811865476]}\n"
      "      - {mass: 2, inertia: {ixx: 1, iyy: 1, izz: 1}, position: [0, -2, 0]}\n");
  // centres at (0, 2, 0) and (0, -2, 0): the sum's is the origin, with 2 * 2 kg * (2 m)^2 across y
  Matrix3d I;
  I << 4 + 1 + 16, -0.5, 0,  //
      -0.5, 3 + 1, 0,        //
      0, 0, 5 + 1 + 16;
  EXPECT_TRUE(sameMass(whole, {4, Vector3d::Zero(), I}, 2e-15));
}

TEST(SceneParts, KeepTheirRules) {
  EXPECT_EQ(errorOf(bodyText("    parts: []\n")),
            kAtParts + "parts must be a list of at least one part, got []");
  EXPECT_EQ(errorOf(bodyText("    parts: {box: 1}\n")),
            kAtParts + "parts must be a list of at least one part, got a mapping");
  EXPECT_EQ(partError("7"), kAtParts +
                                "parts[0] must be a mapping, got 7 (keys: shape, mass, density, "
                                "inertia, center_of_mass, position, orientation)");
  EXPECT_EQ(partError("{mass: 1}"), kAtParts + "parts[0]: missing key 'shape' or 'inertia'");
  EXPECT_EQ(partError("{inertia: {ixx: 1, iyy: 1, izz: 1}}"),
            kAtParts + "parts[0]: missing key 'mass'");
  EXPECT_EQ(partError("{shape: {sphere: {radius: 1}}, mass: 1, center_of_mass: [0, 0, 0]}"),
            kAtParts +
                "parts[0].center_of_mass cannot stand beside shape, which gives it, got "
                "[0, 0, 0]");
  EXPECT_EQ(partError("{shape: {box: [1, 1, 1]}}"),
            kAtParts + "parts[0]: missing key 'mass' or 'density' of the shape");
  EXPECT_EQ(partError("{shape: {sphere: {radius: 1}}, mass: 1, density: 1}"),
            kAtParts + "parts[0].density cannot stand beside mass, got 1");
  EXPECT_EQ(partError("{shape: {sphere: {radius: 1}}, mass: 0}"),
            kAtParts + "parts[0].mass must be > 0 kg, got 0");
  EXPECT_EQ(partError("{shape: {sphere: {radius: 1}}, density: -1}"),
            kAtParts + "parts[0].density must be > 0 kg/m^3, got -1");
  EXPECT_EQ(partError("{shape: {}, mass: 1}"),
            kAtParts + "parts[0].shape must name one shape, got 0");
  EXPECT_EQ(partError("{shape: {box: [1, 1]}, mass: 1}"),
            kAtParts + "parts[0].shape.box must be a list of 3 numbers [m], got [1, 1]");
  EXPECT_EQ(partError("{shape: {sphere: {radius: 1}}, mass: 1}, {shape: {}, at: 1}"),
            kAtParts +
                "unknown key 'parts[1].at' (known: shape, mass, density, inertia, center_of_mass, "
                "position, orientation)");
  EXPECT_EQ(partError("{shape: {sphere: {radius: 1}}, mass: 1, orientation: [0, 0, 0, 2]}"),
            kAtParts +
                "parts[0].orientation must be a unit quaternion [x, y, z, w], its norm within 1e-3 "
                "of 1, got [0, 0, 0, 2] of norm 2");
}

TEST(SceneParticles, AreThePointMassesOfTheMassLayer) {
  Particles particles(3);
  particles[0].mass = 1;
  particles[1].mass = 2;
  particles[1].position = Vector3d(3, 0, 0);
  particles[2].mass = 3;
  particles[2].position = Vector3d(0, 4, 1);
  EXPECT_TRUE(sameMass(massOf("    particles: " + kTriangle + "\n"), massProperties(particles), 0));
}

TEST(SceneParticles, KeepTheirRules) {
  const auto error = [](const std::string& list) {
    return errorOf(bodyText("    particles: " + list + "\n"));
  };
  EXPECT_EQ(error("[]"), kAtParts + "particles must be a list of at least one particle, got []");
  EXPECT_EQ(error("[{mass: 1}]"), kAtParts + "missing key 'particles[0].position'");
  EXPECT_EQ(error("[{position: [0, 0, 0]}]"), kAtParts + "missing key 'particles[0].mass'");
  EXPECT_EQ(error("[{mass: -1, position: [0, 0, 0]}]"),
            kAtParts + "particles[0].mass must be > 0 kg, got -1");
  EXPECT_EQ(error("[{mass: 1, position: [0, 0, 0], velocity: [1, 0, 0]}]"),
            kAtParts + "unknown key 'particles[0].velocity' (known: mass, position)");
  EXPECT_EQ(error("[{mass: 1, position: [0, 0, 0]}, {mass: 1, position: [0, 0, 2]}]"),
            kAtParts + "inertia must be positive definite, got principal moments [0, 2, 2] kg m^2");
}

TEST(SceneMatter, IsOneOfFive) {
  const auto error = [](const std::string& lines) { return errorOf(bodyText(lines)); };
  const std::string shape = "    shape: {sphere: {radius: 1}}\n";
  const std::string parts = "    parts: [{shape: {sphere: {radius: 1}}, mass: 1}]\n";
  const std::string particles = "    particles: " + kTriangle + "\n";
  EXPECT_EQ(
      error(shape + "    mass: 1\n" + parts),
      "s.yaml:6: body 'a': parts cannot stand beside shape, as a body is made of one of them, "
      "got [a mapping]");
  EXPECT_EQ(error(parts + particles),
            "s.yaml:5: body 'a': particles cannot stand beside parts, as a body is made of one of "
            "them, got [a mapping, a mapping, a mapping]");
  for (const auto& [name, text] : {std::pair{"parts", parts}, std::pair{"particles", particles}}) {
    for (const auto& [key, value, shown] :
         {std::tuple{"mass", "1", "1"}, std::tuple{"density", "1", "1"},
          std::tuple{"center_of_mass", "[0, 0, 0]", "[0, 0, 0]"},
          std::tuple{"inertia", "{ixx: 1, iyy: 1, izz: 1}", "a mapping"}})
      EXPECT_EQ(error(text + "    " + key + ": " + value + "\n"),
                std::string("s.yaml:5: body 'a': ") + key + " cannot stand beside " + name +
                    ", which gives it, got " + shown);
  }
}

}  // namespace rigid_body_sim
