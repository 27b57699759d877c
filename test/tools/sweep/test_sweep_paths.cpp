#include <string>

#include <gtest/gtest.h>

#include "tools/sweep/sweep_bench.hpp"

/// Paths that vary nothing, and others that look like them.
namespace rigid_body_sim {
namespace {

/// Of a sweep over one path of the pushed ball, of 2 s, with a mesh to look at.
test::Outcome variedBall(const std::string& path, const std::string& distribution,
                         const std::string& start = "start: 0") {
  const TemporaryDirectory files;
  std::string text = test::kPushedBall;
  const std::string spin = "angular: [0, 0, 1]}";
  text.replace(text.find(spin), spin.size(), spin + ", visual: {mesh: seen.stl}");
  text.replace(text.find("start: 0"), 8, start);
  return test::sweep(
      files.written("scene.yaml", text) + " " +
          files.written("study.yaml", "runs: 2\nvary:\n  " + path + ": {" + distribution + "}\n") +
          " --out " + files.path("out"),
      "PATH=/nonexistent");
}

}  // namespace

TEST(SweepPaths, AreRefusedWhoseOnlyValueMovesNothing) {
  for (const char* distribution : {"list: [2]", "grid: [2.0, 2.0]"}) {
    const test::Outcome run = variedBall("bodies.ball.mass", distribution);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(
        run.out.find("study.yaml:3: vary: 'bodies.ball.mass' varies nothing: the only value, 2"),
        std::string::npos)
        << run.out;
  }
  EXPECT_EQ(variedBall("bodies.ball.visual.mesh", "list: [other.stl]").exit_code, 1);
  EXPECT_EQ(variedBall("integrator", "grid: [auto]").exit_code, 1);
  // another value than the scene's is a choice
  EXPECT_EQ(variedBall("bodies.ball.mass", "list: [3]").exit_code, 0);
  EXPECT_EQ(variedBall("integrator", "grid: [rk4]").exit_code, 0);
}

TEST(SweepPaths, AreRefusedOfWrenchesThatStartAfterTheRun) {
  for (const char* distribution :
       {"uniform: [2, 9]", "list: [2, 3]", "grid: [4, 5]", "normal: {mean: 20, stddev: 1}"}) {
    const test::Outcome run = variedBall("wrenches[0].start", distribution);
    EXPECT_EQ(run.exit_code, 1) << distribution;
    EXPECT_NE(run.out.find("'wrenches[0].start' varies nothing"), std::string::npos) << run.out;
  }
  // some draws are within it
  for (const char* distribution :
       {"uniform: [1.9, 900]", "list: [1, 3]", "normal: {mean: 4, stddev: 1}"})
    EXPECT_EQ(variedBall("wrenches[0].start", distribution).exit_code, 0) << distribution;
  // one that a path beside it may bring into the run, in few of the draws, is a choice as well
  EXPECT_EQ(variedBall("wrenches[0].force[0]", "list: [1, 2]", "start: 3").exit_code, 1);
  EXPECT_EQ(variedBall("wrenches[0].force[0]",
                       "list: [1, 2]}\n  wrenches[0].start: {uniform: [1.9, 1000]", "start: 3")
                .exit_code,
            0);
}

}  // namespace rigid_body_sim
