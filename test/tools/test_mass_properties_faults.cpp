#include <cctype>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mass_properties_program.hpp"
#include "support/mesh_edits.hpp"

namespace rigid_body_sim {

using test::MassPropertiesProgram;
using ::testing::StartsWith;

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
  const Outcome outcome = run(path);
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
  const Outcome outcome = run(path);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, StartsWith("hub\n  mass               3 kg\n"));
  EXPECT_EQ(outcome.error, "mass_properties: notice: " + path +
                               ": material 'paint' is left out: its color must be four numbers "
                               "from 0 to 1, got '1/2 0.2 0 1'\n");
}

TEST_F(MassPropertiesProgram, TellsThatItTurnedAMeshAround) {
  const std::string path =
      files_.written("in.stl", binaryStl(insideOut(triangulated(Box{{1, 1, 1}}, 0))));
  const std::string notice =
      path + ": mesh is oriented inwards (volume -1 m^3): its 12 triangles are turned around\n";
  const Outcome outcome = run(path);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.error, "mass_properties: notice: " + notice);

  const std::string scene = files_.written(
      "s.yaml", "time_step: 1\nbodies:\n  - {name: a, mass: 1, shape: {mesh: {file: in.stl}}}\n");
  EXPECT_EQ(run(scene).error,
            "mass_properties: notice: " + scene + ":3: body 'a': shape.mesh.file: " + notice);
  // a fault has the one line to itself
  const Outcome failed = run(path + " --mass 1e-323");  // its inertia is zero
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_EQ(failed.error.find("notice"), std::string::npos) << failed.error;
}

TEST_F(MassPropertiesProgram, SaysWhatIsWrongWithItsInput) {
  const std::string text = files_.written("a.txt", "x");
  expectFailure(text, 1, text + ":1: a mapping is expected, got x");
  const std::string here = " (looked for in " + std::filesystem::current_path().string() + ")";
  expectFailure("no.stl", 1, "no.stl: mesh file does not exist" + here);
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

TEST_F(MassPropertiesProgram, LeavesPlanesOutAndSaysSo) {
  const std::string start =
      "time_step: 1\nbodies:\n  - {name: ground, shape: {plane: {}}, fixed: true}\n";
  const std::string line = ":3: body 'ground': a plane has no mass properties";
  const std::string with_ball =
      files_.written("ball.yaml", start + "  - {name: a, shape: {sphere: {radius: 1}}, mass: 2}\n");
  const Outcome outcome = run(with_ball);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, StartsWith("a\n  mass               2 kg\n"));
  EXPECT_EQ(outcome.error, "mass_properties: notice: " + with_ball + line + "\n");
  const std::string alone = files_.written("ground.yaml", start);
  expectFailure(alone, 1, alone + line);
}

}  // namespace rigid_body_sim
