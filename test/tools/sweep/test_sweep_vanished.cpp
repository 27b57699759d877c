#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tools/sweep/run_table.hpp"
#include "tools/sweep/sweep_bench.hpp"

/// Tables that are taken away while they are written.
namespace rigid_body_sim {
namespace {

std::string faultOf(RunTable& table) {
  try {
    table.append("1,2\n");
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

}  // namespace

TEST(RunTable, TakesNoRowsThatWouldBeLost) {
  for (const char* how : {"rm -r DIR", "rm DIR/runs.csv", "mv DIR DIR.old",
                          "touch DIR/other && mv DIR/other DIR/runs.csv"}) {
    const TemporaryDirectory files;
    const std::string directory = files.path("out"), path = directory + "/runs.csv";
    std::filesystem::create_directory(directory);
    RunTable table = RunTable::create(LockedFile(path), "run,a");
    EXPECT_EQ(faultOf(table), "");
    std::string command = how;
    for (std::size_t at; (at = command.find("DIR")) != std::string::npos;)
      command.replace(at, 3, directory);
    ASSERT_EQ(test::runCommand(command).exit_code, 0);
    EXPECT_EQ(faultOf(table), path +
                                  ": was removed, moved or replaced while this sweep wrote it; put "
                                  "it back, and the same command with --resume goes on")
        << how;
    EXPECT_THROW(table.requireInPlace(), std::runtime_error);
  }
}

// In the middle of a sweep, which ends at its next write.
TEST(SweepProgram, EndsAsSoonAsItsDirectoryHasVanished) {
  for (const char* gone : {"", "/runs.csv", "/fan.csv"}) {
    const TemporaryDirectory files;
    const std::string scene = files.written("scene.yaml", test::kPushedBall),
                      out = files.path("out");
    const std::string study =
        files.written("study.yaml", "runs: 50000000\nvary: {bodies.ball.mass: {uniform: [1, 2]}}");
    const test::Outcome run = test::runCommand(
        "bash -c '" RIGID_BODY_SIM_SWEEP " " + scene + " " + study + " --out " + out +
        " 2>&1 & until [ $(wc -l <" + out +
        "/runs.csv 2>/dev/null || echo 0) -gt 100 ] || ! kill -0 $!; do sleep 0.01; done "
        "2>/dev/null; rm -r " +
        out + gone + "; wait $!'");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.out.find(": was removed, moved or replaced while this sweep wrote it"),
              std::string::npos)
        << run.out;
  }
}

}  // namespace rigid_body_sim
