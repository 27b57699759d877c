#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/build/body_mass.hpp"
#include "scene/urdf/read_urdf.hpp"
#include "support/mass_difference.hpp"
#include "support/mass_properties_program.hpp"

namespace rigid_body_sim {

using test::MassPropertiesProgram;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace {

const std::string kConfig = RIGID_BODY_SIM_CONFIG;

}  // namespace

TEST_F(MassPropertiesProgram, TellsOfTheUnitCube) {
  const std::string cube = unitCube();
  EXPECT_EQ(out(cube + " --mass 6"),
            "unit_cube: volume 1 m^3, density 6 kg/m^3\n"
            "  mass               6 kg\n"
            "  centre of mass     [0, 0, 0] m in the body frame\n"
            "  inertia            [1, 0, 0] kg m^2 about the centre of mass, in body axes\n"
            "                     [0, 1, 0]\n"
            "                     [0, 0, 1]\n"
            "  principal moments  [1, 1, 1] kg m^2\n"
            "  principal axes     [1, 0, 0] in the body frame\n"
            "                     [0, 1, 0]\n"
            "                     [0, 0, 1]\n");
  EXPECT_EQ(out(cube + " --density 6 --format yaml"),
            "bodies:\n  - name: unit_cube  # volume 1 m^3, density 6 kg/m^3\n    mass: 6\n"
            "    center_of_mass: [0, 0, 0]\n"
            "    inertia: {ixx: 1, iyy: 1, izz: 1, ixy: 0, ixz: 0, iyz: 0}\n");
  EXPECT_EQ(out(cube + " --density 6 --format urdf"),
            "<!-- unit_cube: volume 1 m^3, density 6 kg/m^3 -->\n<inertial>\n"
            "  <origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>\n  <mass value=\"6\"/>\n"
            "  <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n"
            "</inertial>\n");
}

TEST_F(MassPropertiesProgram, ScalesAMesh) {
  EXPECT_EQ(out(unitCube() + " --density 6 --scale 0.5 --format yaml"),
            "bodies:\n"
            "  - name: unit_cube  # volume 0.125 m^3, density 6 kg/m^3\n"
            "    mass: 0.75\n"
            "    center_of_mass: [0, 0, 0]\n"
            "    inertia: {ixx: 0.03125, iyy: 0.03125, izz: 0.03125, ixy: 0, ixz: 0, iyz: 0}\n");
}

TEST_F(MassPropertiesProgram, SaysWhatDensityItAssumed) {
  EXPECT_THAT(out(unitCube()),
              StartsWith("unit_cube: volume 1 m^3, density 1000 kg/m^3 (assumed: neither --density "
                         "nor --mass is given)\n  mass               1000 kg\n"));
}

TEST_F(MassPropertiesProgram, WritesYamlThatMakesTheSameBodies) {
  for (const std::string name : {"tools_in_orbit", "thrown_rover", "wing_nut"}) {
    const std::string path = kConfig + "/scenes/" + name + ".yaml";
    const Scene scene = loadScene(path);
    const std::vector<BodyDef> again = pasted(out(path + " --format yaml"));
    ASSERT_EQ(again.size(), scene.bodies.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
      EXPECT_EQ(again[i].name, scene.bodies[i].name);
      // 17 digits name a double: not a bit is lost
      EXPECT_TRUE(sameMass(massProperties(again[i]), massProperties(scene.bodies[i]), 0));
    }
  }
}

TEST_F(MassPropertiesProgram, WritesYamlOfAMeshThatMakesTheSameBody) {
  const std::string path = kConfig + "/meshes/wing_nut.stl";
  const Scene scene = parseScene(
      "time_step: 1\nbodies: [{name: a, density: 7850, shape: {mesh: "
      "{file: " +
          path + "}}}]",
      "s");
  EXPECT_TRUE(sameMass(massProperties(pasted(out(path + " --density 7850 --format yaml")).at(0)),
                       massProperties(scene.bodies[0]), 0));
}

TEST_F(MassPropertiesProgram, WritesUrdfThatMakesTheSameBody) {
  const std::string mesh = kConfig + "/meshes/l_bracket.obj --mass 3 --format ";
  EXPECT_TRUE(sameMass(pastedInertial(out(mesh + "urdf")),
                       massProperties(pasted(out(mesh + "yaml")).at(0)), 0));

  const std::string path = kConfig + "/urdf/rover.urdf";
  const std::vector<UrdfLink> links = readUrdf(path).links;
  const std::string all = out(path + " --format urdf");
  std::size_t at = 0;
  for (const UrdfLink& link : links) {
    at = all.find("<inertial>", at);
    ASSERT_NE(at, std::string::npos);
    const std::size_t end = all.find("</inertial>", at) + 11;
    EXPECT_TRUE(sameMass(pastedInertial(all.substr(at, end - at)), *link.mass, 0));
    at = end;
  }
}

TEST_F(MassPropertiesProgram, LeavesOutLinksWithoutInertial) {
  const std::string path = files_.written(
      "r.urdf",
      "<robot name='r'><link name='a--b'><inertial><mass value='1'/><inertia ixx='1' ixy='0' "
      "ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link><link name='c'/><joint name='j' "
      "type='fixed'><parent link='a--b'/><child link='c'/></joint></robot>");
  EXPECT_THAT(out(path), StartsWith("a--b\n  mass               1 kg\n"));
  EXPECT_THAT(out(path + " --format urdf"), StartsWith("<!-- a- -b -->\n"));
  expectFailure(files_.written("none.urdf", "<robot name='r'><link name='a'/></robot>"), 1,
                files_.path("none.urdf") + ": no link has an <inertial>");
}

TEST_F(MassPropertiesProgram, MakesANameOfTheFile) {
  const std::string stl = binaryStl(triangulated(Box{{1, 1, 1}}, 0));
  EXPECT_THAT(out(files_.written("part-2 b.STL", stl).insert(0, "'") + "' --mass 1"),
              StartsWith("part_2_b: "));
  EXPECT_THAT(out(files_.written("42.stl", stl) + " --mass 1"), StartsWith("mesh_42: "));
}

TEST_F(MassPropertiesProgram, WritesYamlOfLinksThatAnySceneAccepts) {
  std::string urdf = "<robot name='r'>";
  for (const std::string name : {"base_link", "base-link", "left wheel: 2", "2nd", "world", "fine"})
    urdf += "<link name='" + name +
            "'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
            "izz='1'/></inertial></link>";
  for (const std::string name : {"base-link", "left wheel: 2", "2nd", "world", "fine"})
    urdf += "<joint name='of " + name + "' type='fixed'><parent link='base_link'/><child link='" +
            name + "'/></joint>";
  const std::string yaml = out(files_.written("r.urdf", urdf + "</robot>") + " --format yaml");
  std::vector<std::string> names;
  for (const BodyDef& body : pasted(yaml)) names.push_back(body.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"base_link", "base_link_2", "fine", "left_wheel__2",
                                             "link_2nd", "link_world"}));
  EXPECT_THAT(yaml, HasSubstr("  - name: left_wheel__2  # left wheel: 2 in the file\n"));
  EXPECT_THAT(yaml, HasSubstr("  - name: fine\n"));
}

TEST_F(MassPropertiesProgram, TakesASceneByAnyName) {
  const std::string scene = files_.written(
      "orbit.scene", "time_step: 1\nbodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1}]\n");
  EXPECT_THAT(out(scene), StartsWith("a\n  mass               1 kg\n"));
}

TEST_F(MassPropertiesProgram, WritesNumbersInTheFewestDigitsThatReadBack) {
  const std::string scene = files_.written(
      "s.yaml",
      "time_step: 1\nbodies: [{name: a, mass: 0.03, center_of_mass: [0.1, 0.2, 0.3], inertia: "
      "{ixx: 0.029999999999999999, iyy: 0.03, izz: 0.05}}]\n");
  EXPECT_EQ(out(scene + " --format yaml"),
            "bodies:\n  - name: a\n    mass: 0.03\n    center_of_mass: [0.1, 0.2, 0.3]\n"
            "    inertia: {ixx: 0.03, iyy: 0.03, izz: 0.05, ixy: 0, ixz: 0, iyz: 0}\n");
}

TEST_F(MassPropertiesProgram, ExplainsItself) {
  const std::string help = out("--help");
  EXPECT_THAT(help, StartsWith("usage: mass_properties FILE [options]\n"));
  for (const char* word :
       {"--density", "--mass", "--scale", "--format", "text", "yaml", "urdf", "Exit status"})
    EXPECT_THAT(help, HasSubstr(word));
}

}  // namespace rigid_body_sim
