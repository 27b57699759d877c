#include <filesystem>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/build/body_mass.hpp"
#include "scene/build/visuals_of.hpp"
#include "support/mass_difference.hpp"

namespace rigid_body_sim {
namespace {

BodyDef bodyOf(const std::string& entry) {
  return parseScene("time_step: 0.01\nbodies: [{name: a, " + entry + "}]", "s").bodies[0];
}

const Shape& shapeOf(const Visual& visual) { return std::get<Shape>(visual.geometry); }

}  // namespace

TEST(VisualsOf, DrawTheShapeWhereItIs) {
  const auto visuals = visualsOf(bodyOf("shape: {cone: {radius: 1, length: 2}}, mass: 1"));
  ASSERT_EQ(visuals.size(), 1U);
  EXPECT_EQ(std::get<Cone>(shapeOf(visuals[0])).length, 2);
  EXPECT_TRUE(visuals[0].X_BV.matrix().isIdentity(0));
  EXPECT_FALSE(visuals[0].color);
}

TEST(VisualsOf, DrawEveryPartInItsPlaceAndInOneColour) {
  const auto visuals =
      visualsOf(bodyOf("visual: {color: [0.1, 0.2, 0.3, 1]}, parts: ["
                       "{shape: {box: [1, 1, 1]}, mass: 1, position: [1, 2, 3]}, "
                       "{shape: {sphere: {radius: 2}}, mass: 1, orientation: [0, 0, 1, 0]}]"));
  ASSERT_EQ(visuals.size(), 2U);
  EXPECT_EQ(visuals[0].X_BV.translation(), Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<Sphere>(shapeOf(visuals[1])).radius, 2);
  EXPECT_EQ(visuals[1].X_BV.linear().col(0), Vector3d(-1, 0, 0));
  for (const Visual& visual : visuals) EXPECT_EQ(visual.color, (Color{0.1, 0.2, 0.3, 1}));
}

TEST(VisualsOf, DrawParticlesAsSpheresOfTheirMass) {
  const auto visuals = visualsOf(
      bodyOf("particles: [{mass: 8, position: [0, 0, 0]}, {mass: 1, position: [9, 0, 0]}, "
             "{mass: 1, position: [0, 9, 0]}]"));
  ASSERT_EQ(visuals.size(), 3U);
  const double heaviest = std::get<Sphere>(shapeOf(visuals[0])).radius;
  EXPECT_GT(heaviest, 0);
  EXPECT_LT(heaviest, 9.0 / 10);
  EXPECT_DOUBLE_EQ(std::get<Sphere>(shapeOf(visuals[1])).radius, heaviest / 2);
  EXPECT_EQ(visuals[1].X_BV.translation(), Vector3d(9, 0, 0));
}

TEST(VisualsOf, DrawGivenPropertiesAsTheBoxThatHasThem) {
  const BodyDef body = bodyOf(
      "mass: 12, inertia: {ixx: 13, iyy: 10, izz: 5, ixy: 1, ixz: 0.5, iyz: -0.5}, "
      "center_of_mass: [0.1, 0.2, 0.3]");
  const auto visuals = visualsOf(body);
  ASSERT_EQ(visuals.size(), 1U);
  const MassProperties box = transformed(visuals[0].X_BV, massProperties(shapeOf(visuals[0]), 12));
  EXPECT_TRUE(sameMass(box, massProperties(body), 1e-14));
}

TEST(VisualsOf, GiveAFlatPlateAThickness) {
  const auto visuals = visualsOf(bodyOf("mass: 1, inertia: {ixx: 1, iyy: 2, izz: 3}"));
  EXPECT_GT(std::get<Box>(shapeOf(visuals[0])).size.minCoeff(), 0);
}

TEST(VisualsOf, DrawTheMeshOfVisualInPlaceOfAll) {
  const auto urlOf = [](const std::string& mesh) {
    const auto visuals = visualsOf(bodyOf("shape: {box: [1, 1, 1]}, mass: 1, visual: {mesh: '" +
                                          mesh + "', color: [1, 1, 1, 1]}"));
    EXPECT_EQ(visuals.size(), 1U);
    EXPECT_EQ(visuals.at(0).color, (Color{1, 1, 1, 1}));
    return std::get<MeshVisual>(visuals.at(0).geometry).url;
  };
  EXPECT_EQ(urlOf("package://p/a.stl"), "package://p/a.stl");
  EXPECT_EQ(urlOf("https://p/a.stl"), "https://p/a.stl");
  EXPECT_EQ(urlOf("/m/100% a#1.stl"), "file:///m/100%25%20a%231.stl");
  EXPECT_EQ(urlOf("a.stl"), "file://" + (std::filesystem::current_path() / "a.stl").string());
}

TEST(VisualsOf, DrawAMeshFromItsFileAtItsScale) {
  const BodyDef body =
      loadScene(std::string(RIGID_BODY_SIM_SCENES) + "/tools_in_orbit.yaml").bodies.at(1);
  const auto visuals = visualsOf(body);
  ASSERT_EQ(visuals.size(), 1U);
  const auto& mesh = std::get<MeshVisual>(visuals[0].geometry);
  EXPECT_EQ(mesh.scale, Vector3d(0.5, 0.5, 0.5));
  EXPECT_EQ(mesh.url.substr(0, 8), "file:///");
  EXPECT_EQ(mesh.url.substr(mesh.url.rfind('/')), "/l_bracket.obj");
}

}  // namespace rigid_body_sim
