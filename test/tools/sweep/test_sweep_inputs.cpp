#include <string>

#include <gtest/gtest.h>

#include "tools/sweep/sweep_bench.hpp"

/// What decides whether two sweeps are the same.
namespace rigid_body_sim {

// The text that comes through a pipe is there once.
TEST(SweepProgram, TellsStudiesFromPipesApart) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const auto swept = [&](const std::string& mass, const std::string& options) {
    const std::string study = "runs: 3\nvary: {bodies.ball.mass: {list: [" + mass + "]}}\n";
    return test::runCommand("cat " + files.written("study.yaml", study) + " | PATH=/nonexistent " +
                            RIGID_BODY_SIM_SWEEP + " " + scene + " /dev/stdin --out " +
                            files.path("out") + options + " 2>&1");
  };
  ASSERT_EQ(swept("1, 2", "").exit_code, 0);
  const std::string rows = test::fileText(files.path("out/runs.csv"));
  EXPECT_EQ(swept("1, 2", " --resume").exit_code, 0);
  const test::Outcome other = swept("3, 4", " --resume");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.out.find("is of another sweep"), std::string::npos) << other.out;
  EXPECT_EQ(test::fileText(files.path("out/runs.csv")), rows);
}

}  // namespace rigid_body_sim
