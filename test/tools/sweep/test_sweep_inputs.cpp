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

// Only what is in the files counts.
TEST(SweepProgram, GoesOnWithRenamedFilesAndAsManyRuns) {
  const TemporaryDirectory files;
  const std::string text = "runs: 4\nvary: {bodies.ball.mass: {uniform: [1, 2]}}";
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml", text), out = " --out " + files.path("out");
  const std::string no_plot = "PATH=/nonexistent";
  ASSERT_EQ(test::sweep(scene + " " + study + out + " --runs 5", no_plot).exit_code, 0);
  const std::string other =
      files.written("other.yaml", test::kPushedBall) + " " + files.written("renamed.yaml", text);
  EXPECT_EQ(test::sweep(other + out + " --runs 5 --resume", no_plot).exit_code, 0);
  EXPECT_EQ(test::sweep(scene + " " + study + out + " --resume", no_plot).out,
            "sweep: " + files.path("out/runs.csv") +
                ": is of 5 runs, with the grids, and not of 4; --runs was another\n");
}

// A value of a Latin hypercube depends on the number of runs, too.
TEST(SweepProgram, WritesOfHowManyRunsASceneIs) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml",
                                          "runs: 4\nlatin_hypercube: true\n"
                                          "vary: {bodies.ball.mass: {uniform: [1, 2]}}");
  ASSERT_EQ(test::sweep("--run 2 --runs 6 " + scene + " " + study + " --out " + files.path("out"))
                .exit_code,
            0);
  const std::string text = test::fileText(files.path("out/run_2.yaml"));
  EXPECT_EQ(text.find("# run 2 of 6 runs of scene.yaml, study.yaml, seed 0\n"), 0U) << text;
}

TEST(SweepProgram, SaysAllThatAMergeLacks) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: 4\nvary: {bodies.ball.mass: {uniform: [1, 2]}}");
  const std::string a = files.path("a"), b = files.path("b"), no_plot = "PATH=/nonexistent";
  const std::string command = scene + " " + study + " --out ";
  ASSERT_EQ(test::sweep(command + a + " --shard 3/4", no_plot).exit_code, 0);
  EXPECT_EQ(test::sweep("merge " + a).out,
            "sweep: runs.1of4.csv, runs.2of4.csv, runs.4of4.csv: these shards are missing\n");
  ASSERT_EQ(test::sweep(command + b + " --shard 3/5", no_plot).exit_code, 0);
  EXPECT_EQ(test::sweep("merge " + a + " " + b).out,
            "sweep: " + b + "/runs.3of5.csv: is of another number of shards than " + a +
                "/runs.3of4.csv\n");
  EXPECT_EQ(test::sweep("merge " + a + " " + a).out,
            "sweep: " + a + "/runs.3of4.csv: is there twice, in " + a + ", too\n");
}

// The greatest values that there are have no sum, so that their mean is not known.
TEST(SweepProgram, SummarisesTheGreatestNumbers) {
  const TemporaryDirectory files;
  const std::string inputs =
      files.written("scene.yaml",
                    "gravity: [0, 0, 0]\ntime_step: 0.01\nhorizon: 1\nbodies:\n"
                    "  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 2, "
                    "position: [0, 0, 0]}\n") +
      " " +
      files.written("study.yaml",
                    "runs: 30\nvary: {'bodies.ball.position[0]': {uniform: [-1.7e308, 1.7e308]}}\n"
                    "record: {x: {at_end: ball.px}}");
  const test::Outcome run = test::sweep(inputs + " --out " + files.path("out"));
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.out.find("nan"), std::string::npos) << run.out;
  EXPECT_EQ(test::fileText(files.path("out/summary.csv")).find("nan"), std::string::npos);
}

}  // namespace rigid_body_sim
