#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/build/body_mass.hpp"
#include "scene/urdf/read_urdf.hpp"
#include "support/mass_difference.hpp"
#include "support/mesh_edits.hpp"
#include "support/mesh_texts.hpp"
#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kConfig = RIGID_BODY_SIM_CONFIG;

struct OutcomeWithError : test::Outcome {
  std::string error;  ///< what it wrote to standard error
};

class MassPropertiesProgram : public ::testing::Test {
 protected:
  /// Runs the program with the arguments, one string as a shell takes it.
  OutcomeWithError run(const std::string& arguments) const {
    const std::string error_path = files_.path("error.txt");
    const std::string command =
        std::string(RIGID_BODY_SIM_MASS_PROPERTIES) + " " + arguments + " 2>" + error_path;
    const test::Outcome outcome = test::runCommand(command);
    std::ostringstream error;
    error << std::ifstream(error_path).rdbuf();
    return {outcome, error.str()};
  }

  /// The output of a run that must go well.
  std::string out(const std::string& arguments) const {
    const OutcomeWithError outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return outcome.out;
  }

  /// The bodies of a scene that is nothing but what --format yaml writes.
  static std::vector<BodyDef> pasted(const std::string& yaml) {
    return parseScene("time_step: 1\n" + yaml, "pasted").bodies;
  }

  /// The one link of a URDF file with the <inertial> that --format urdf writes.
  MassProperties pastedInertial(const std::string& inertial) const {
    return *readUrdf(files_.written("pasted.urdf", "<robot name='r'><link name='l'>" + inertial +
                                                       "</link></robot>"))
                .links.at(0)
                .mass;
  }

  /// A run that must fail with the code and one line.
  void expectFailure(const std::string& arguments, int code, const std::string& line) const {
    const OutcomeWithError outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, code) << arguments;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error, "mass_properties: " + line + "\n");
  }

  /// A file of a cube of 1 m about the origin.
  std::string unitCube() const {
    return files_.written("unit_cube.stl", binaryStl(triangulated(Box{{1, 1, 1}}, 0)));
  }

  TemporaryDirectory files_;
};

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

TEST_F(MassPropertiesProgram, PrintsTheGoodLinksAndNamesTheOthers) {
  const auto link = [](const std::string& name, const std::string& mass, const std::string& izz) {
    return "<link name='" + name + "'><inertial><mass value='" + mass +
           "'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='" + izz +
           "'/></inertial></link>";
  };
  const std::string path = files_.written(
      "arm.urdf", "<robot name='arm'>" + link("upper", "2", "1") + link("tool_point", "0", "1") +
                      link("finger", "0.1", "4") +
                      "<joint name='j' type='fixed'><parent link='upper'/><child "
                      "link='tool_point'/></joint><joint name='k' type='fixed'><parent "
                      "link='tool_point'/><child link='finger'/></joint></robot>");
  const OutcomeWithError outcome = run(path);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, StartsWith("upper\n  mass               2 kg\n"));
  EXPECT_EQ(outcome.out.find("finger"), std::string::npos);
  EXPECT_EQ(outcome.error,
            "mass_properties: " + path +
                ": link 'finger': inertia must satisfy the triangle inequality I1 + I2 >= I3, got "
                "principal moments [1, 1, 4] kg m^2: 2 < 4\n"
                "mass_properties: " +
                path + ": link 'tool_point': mass must be > 0 kg, got 0\n");
}

TEST_F(MassPropertiesProgram, UsesALinkWhoseColourItCannotRead) {
  const std::string path = files_.written(
      "disc.urdf",
      "<robot name='disc'><material name='paint'><color rgba='1/2 0.2 0 1'/></material>"
      "<link name='hub'><inertial><mass value='3'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' "
      "iyz='0' izz='1'/></inertial><visual><geometry><box size='1 1 1'/></geometry><material "
      "name='paint'/></visual></link></robot>");
  const OutcomeWithError outcome = run(path);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, StartsWith("hub\n  mass               3 kg\n"));
  EXPECT_EQ(outcome.error, "mass_properties: notice: " + path +
                               ": material 'paint' is left out: its color must be four numbers "
                               "from 0 to 1, got '1/2 0.2 0 1'\n");
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

TEST_F(MassPropertiesProgram, TellsThatItTurnedAMeshAround) {
  const std::string path =
      files_.written("in.stl", binaryStl(insideOut(triangulated(Box{{1, 1, 1}}, 0))));
  const std::string notice =
      path + ": mesh is oriented inwards (volume -1 m^3): its 12 triangles are turned around\n";
  const OutcomeWithError outcome = run(path);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.error, "mass_properties: notice: " + notice);

  const std::string scene = files_.written(
      "s.yaml", "time_step: 1\nbodies:\n  - {name: a, mass: 1, shape: {mesh: {file: in.stl}}}\n");
  EXPECT_EQ(run(scene).error,
            "mass_properties: notice: " + scene + ":3: body 'a': shape.mesh.file: " + notice);
  // a fault has the one line to itself
  const OutcomeWithError failed = run(path + " --mass 1e-323");  // its inertia is zero
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_EQ(failed.error.find("notice"), std::string::npos) << failed.error;
}

TEST_F(MassPropertiesProgram, SaysWhatIsWrongWithItsInput) {
  const std::string text = files_.written("a.txt", "x");
  expectFailure(text, 1, text + ":1: a mapping is expected, got x");
  expectFailure("no.stl", 1, "no.stl: mesh file does not exist");
  const std::string here = " (looked for in " + std::filesystem::current_path().string() + ")";
  expectFailure("no.yaml", 1, "no.yaml: cannot be opened: No such file or directory" + here);
  expectFailure("no.urdf", 1, "no.urdf: cannot be opened: No such file or directory" + here);
  const std::string scene = files_.written("s.yaml", "time_step: 1\nbodies: []\n");
  expectFailure(scene, 1, scene + ":2: bodies must be a list of at least one body, got []");
  const std::string package = files_.written(
      "p.yaml",
      "time_step: 1\nbodies: [{name: a, urdf: {file: 'package://no_such_package/r', link: l}}]\n");
  expectFailure(package, 1,
                package +
                    ":2: body 'a': urdf.file must name a ROS package that is on ROS_PACKAGE_PATH, "
                    "got \"package://no_such_package/r\"");
  const std::string urdf = files_.written(
      "r.urdf",
      "<robot name='r'><link name='l'><inertial><mass value='0'/><inertia ixx='1' ixy='0' ixz='0' "
      "iyy='1' iyz='0' izz='1'/></inertial></link></robot>");
  expectFailure(urdf, 1, urdf + ": link 'l': mass must be > 0 kg, got 0");
}

TEST_F(MassPropertiesProgram, RefusesFilesOfOtherTypesByName) {
  const std::string supported =
      "; supported: .stl, .obj, .dae (meshes), .urdf, .xml (URDF), any other name (scenes)";
  for (const std::string extension : {".ply", ".glb", ".sdf", ".GLTF", ".step"}) {
    const std::string path = files_.written("part" + extension, "ply\n");
    std::string lower = extension;
    for (char& c : lower) c = static_cast<char>(std::tolower(c));
    expectFailure(path, 1, path + ": unsupported file type " + lower + supported);
  }
  const std::string xacro = files_.written("r.xacro", "<robot/>");
  expectFailure(
      xacro, 1,
      xacro + ": unsupported file type .xacro" + supported + "; xacro makes a .urdf of it");
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

TEST_F(MassPropertiesProgram, SaysWhatIsWrongWithItsUsage) {
  const std::string help = " (mass_properties --help)";
  expectFailure("", 2, "exactly one file is needed, got 0" + help);
  expectFailure("a.stl b.stl", 2, "exactly one file is needed, got 2" + help);
  expectFailure("a.stl --colour", 2, "unknown option --colour" + help);
  expectFailure("a.stl --mass", 2, "--mass needs a value" + help);
  expectFailure("a.stl --mass -1", 2, "--mass: must be a finite number > 0, got '-1'" + help);
  expectFailure("a.stl --density x", 2, "--density: must be a finite number > 0, got 'x'" + help);
  expectFailure("a.stl --scale -1", 2, "--scale: must be a finite number > 0, got '-1'" + help);
  expectFailure("a.yaml --scale 2", 2,
                "--scale goes with a mesh; a.yaml says how large its bodies are" + help);
  expectFailure("a.stl --mass 1 --density 1", 2, "--density cannot stand beside --mass" + help);
  expectFailure("a.stl --format xml", 2, "--format: must be text, urdf or yaml, got 'xml'" + help);
  expectFailure("a.yaml --mass 1", 2,
                "--density and --mass go with a mesh; a.yaml says what its bodies weigh" + help);
}

TEST_F(MassPropertiesProgram, ExplainsItself) {
  const std::string help = out("--help");
  EXPECT_THAT(help, StartsWith("usage: mass_properties FILE [options]\n"));
  for (const char* word :
       {"--density", "--mass", "--scale", "--format", "text", "yaml", "urdf", "Exit status"})
    EXPECT_THAT(help, HasSubstr(word));
}

}  // namespace rigid_body_sim
