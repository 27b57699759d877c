#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "support/mesh_edits.hpp"
#include "support/mesh_texts.hpp"
#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

const std::string kCensus = RIGID_BODY_SIM_CONFIG "/../scripts/census --program ";

}  // namespace

TEST(Census, CountsWhatWasReadPutRightAndRefusedByKind) {
  TemporaryDirectory files;
  auto cube = triangulated(Box{{1, 1, 1}}, 0);
  files.written("meshes/cube.stl", binaryStl(cube));
  files.written("meshes/deep/CUBE.STL", binaryStl(cube));
  files.written("meshes/inwards.stl", binaryStl(insideOut(cube)));
  files.written("meshes/empty.stl", "");
  files.written("meshes/short.obj", "v 0 0 0\n");
  files.written("meshes/notes.txt", "not a mesh");
  files.written("meshes/r.urdf",
                "<robot name='r'><link name='a'><inertial><mass value='1'/><inertia ixx='1' "
                "ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link></robot>");
  const test::Outcome run =
      test::runCommand(kCensus + RIGID_BODY_SIM_MASS_PROPERTIES " " + files.path("meshes") +
                       " --csv " + files.path("census.csv") + " 2>&1");
  EXPECT_EQ(run.exit_code, 0) << run.out;
  const std::string expected =
      "kind       files       read  put right    in part    refused    crashed\n"
      "OBJ            1          0          0          0          1          0\n"
      "STL            4          2          1          0          1          0\n"
      "URDF           1          1          0          0          0          0\n"
      "all            6          3          1          0          2          0\n";
  EXPECT_EQ(run.out.substr(0, expected.size()), expected) << run.out;
  EXPECT_NE(run.out.find("\nput right:\n      1 STL   mesh is oriented inwards"), std::string::npos)
      << run.out;

  std::ostringstream csv;
  csv << std::ifstream(files.path("census.csv")).rdbuf();
  EXPECT_EQ(csv.str().find("path,kind,result,reason,message"), 0U) << csv.str();
  EXPECT_NE(csv.str().find("inwards.stl,STL,put right,mesh is oriented inwards"), std::string::npos)
      << csv.str();
}

TEST(Census, FailsWhereTheProgramCrashes) {
  TemporaryDirectory files;
  files.written("cube.stl", "any");
  const test::Outcome run =
      test::runCommand(kCensus + files.written("crash", "#!/bin/sh\nkill -SEGV $$\n") + " " +
                       files.path("") + " 2>&1");
  EXPECT_NE(run.exit_code, 0);
  const test::Outcome executable =
      test::runCommand("chmod +x " + files.path("crash") + "; " + kCensus + files.path("crash") +
                       " " + files.path("") + " 2>&1");
  EXPECT_EQ(executable.exit_code, 1);
  EXPECT_NE(executable.out.find("crashed:\n      1 STL   exit status"), std::string::npos)
      << executable.out;
}

}  // namespace rigid_body_sim
