#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/urdf/read_urdf.hpp"
#include "support/mesh_texts.hpp"
#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim::test {

/// Runs of mass_properties.
class MassPropertiesProgram : public ::testing::Test {
 protected:
  struct Outcome : test::Outcome {
    std::string error;  ///< what it wrote to standard error
  };

  /// Runs the program with the arguments, one string as a shell takes it.
  Outcome run(const std::string& arguments) const {
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
    const Outcome outcome = run(arguments);
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
    const Outcome outcome = run(arguments);
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

}  // namespace rigid_body_sim::test
