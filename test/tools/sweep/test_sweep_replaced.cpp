#include <cstdio>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include "tools/sweep/sweep_bench.hpp"

/// Tables in the place of others.
namespace rigid_body_sim {
namespace {

using test::fileText;

const std::string kNoPlot = "PATH=/nonexistent";

struct Bench : test::SweepFiles {
  Bench() : SweepFiles(test::kPushedBall, "runs: 6\nvary: {bodies.ball.mass: {list: [1, 2]}}") {}

  test::Outcome sweep(const std::string& options = "") const {
    return test::sweep(command() + " " + options, kNoPlot);
  }
  /// Leaves the first rows of a table.
  void cut(const std::string& name, int rows) const {
    std::ifstream in(out + "/" + name);
    std::string line, text;
    for (int i = 0; i <= rows && std::getline(in, line); ++i) text += line + "\n";
    files.written("out/" + name, text);
  }
};

}  // namespace

TEST(SweepProgram, ThrowsNoRowsOfAnUnfinishedSweepAway) {
  const Bench bench;
  ASSERT_EQ(bench.sweep().exit_code, 0);
  const std::string table = bench.out + "/runs.csv", whole = fileText(table);
  ASSERT_EQ(bench.sweep().exit_code, 0) << "a finished one is made again";
  bench.cut("runs.csv", 4);
  const std::string rows = fileText(table);
  const test::Outcome again = bench.sweep();
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_EQ(again.out, "sweep: " + table +
                           ": holds 4 of 6 runs of this sweep; --resume goes on, or remove it to "
                           "begin anew\n");
  EXPECT_EQ(fileText(table), rows);
  EXPECT_EQ(bench.sweep("--resume").exit_code, 0);
  EXPECT_EQ(fileText(table), whole);
  // of another sweep they are replaced, which is said
  bench.cut("runs.csv", 4);
  const test::Outcome other = bench.sweep("--seed 5");
  EXPECT_EQ(other.exit_code, 0);
  EXPECT_EQ(other.out.find("sweep: notice: " + table +
                           ": holds 4 of 6 runs of scene.yaml, study.yaml, which are replaced\n"),
            0U)
      << other.out;
}

TEST(SweepProgram, ReplacesNoFileThatIsNoTable) {
  const Bench bench;
  ASSERT_EQ(bench.sweep().exit_code, 0);
  ASSERT_EQ(test::runCommand("mkdir " + bench.files.path("merged")).exit_code, 0);
  const std::string mine = "my,own,data\n1,2,3\n";
  for (const std::string& text : {mine, std::string("a,b"), std::string("run,a,b\n1,2,3\n")}) {
    bench.files.written("out/runs.csv", text);
    remove((bench.out + "/runs.info").c_str());
    for (const char* options : {"", "--resume"}) {
      EXPECT_EQ(bench.sweep(options).exit_code, 1) << text << options;
      EXPECT_EQ(fileText(bench.out + "/runs.csv"), text);
    }
    EXPECT_EQ(bench.sweep().out, "sweep: " + bench.out +
                                     "/runs.csv: is no table of a sweep, and would be replaced; "
                                     "remove it, or name another --out\n");
    bench.files.written("out/runs.csv", "");
    ASSERT_EQ(bench.sweep().exit_code, 0);
    bench.files.written("merged/runs.csv", text);
    EXPECT_EQ(test::sweep("merge " + bench.out + " --out " + bench.files.path("merged"), kNoPlot)
                  .exit_code,
              1);
    EXPECT_EQ(fileText(bench.files.path("merged/runs.csv")), text);
  }
  bench.files.written("out/fan.csv", mine);
  EXPECT_EQ(bench.sweep().exit_code, 1);
  EXPECT_EQ(fileText(bench.out + "/fan.csv"), mine);
}

TEST(SweepProgram, MergesIntoNoDirectoryThatASweepIsWriting) {
  const Bench bench;
  for (const char* shard : {"1/2", "2/2"})
    ASSERT_EQ(bench.sweep(std::string("--shard ") + shard).exit_code, 0);
  ASSERT_EQ(test::sweep("merge " + bench.out, kNoPlot).exit_code, 0);
  const std::string table = bench.out + "/runs.csv", rows = fileText(table);
  const int other = open(table.c_str(), O_WRONLY | O_APPEND);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  const test::Outcome merged = test::sweep("merge " + bench.out, kNoPlot);
  EXPECT_EQ(merged.exit_code, 1);
  EXPECT_EQ(merged.out, "sweep: " + table +
                            ": another sweep is writing it; wait for it, or name another --out\n");
  EXPECT_EQ(fileText(table), rows);
  // as one that begins, of which there is nothing yet
  bench.files.written("out/runs.csv", "");
  EXPECT_EQ(test::sweep("merge " + bench.out, kNoPlot).exit_code, 1);
  close(other);
  EXPECT_EQ(test::sweep("merge " + bench.out, kNoPlot).exit_code, 0);
  EXPECT_EQ(fileText(table), rows);
}

TEST(SweepProgram, LeavesNothingThatWasMadeOfAnotherTable) {
  const Bench bench;
  const auto isThere = [&](const std::string& name) {
    return std::ifstream(bench.out + "/" + name).good();
  };
  const auto markOld = [&] {
    bench.files.written("out/summary.csv", "column,count,mean,stddev,min\n");
    bench.files.written("out/sweep.svg", "<svg><title>rigid_body_sim_sweep</title></svg>\n");
  };
  ASSERT_EQ(bench.sweep().exit_code, 0);
  ASSERT_TRUE(isThere("fan.csv"));
  markOld();
  // what is not finished does not say so by what is beside it
  // where the horizon varies there is no fan
  const std::string study =
      bench.files.written("other.yaml", "runs: 4\nvary: {horizon: {list: [1, 2]}}");
  const std::string other = bench.scene + " " + study + " --out " + bench.out;
  const std::string text = test::sweep(other, kNoPlot).out;
  EXPECT_FALSE(isThere("fan.csv")) << text;
  EXPECT_FALSE(isThere("sweep.svg"));
  EXPECT_NE(fileText(bench.out + "/summary.csv").find("horizon"), std::string::npos);

  const std::string shards = bench.files.path("shards");
  for (const char* shard : {"1/2", "2/2"})
    ASSERT_EQ(
        test::sweep(bench.scene + " " + study + " --out " + shards + " --shard " + shard, kNoPlot)
            .exit_code,
        0);
  ASSERT_EQ(bench.sweep().exit_code, 0);
  markOld();
  ASSERT_EQ(test::sweep("merge " + shards + " --out " + bench.out, kNoPlot).exit_code, 0);
  EXPECT_FALSE(isThere("fan.csv"));
  EXPECT_FALSE(isThere("sweep.svg"));
}

TEST(SweepProgram, OverwritesNoFileThatTheSceneNames) {
  const TemporaryDirectory files;
  const std::string robot =
      "<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
      "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link></robot>";
  files.written("run_3.yaml", robot);
  const std::string scene = files.written(
      "s.yaml",
      "time_step: 0.01\nbodies: [{name: ball, urdf: {file: run_3.yaml}, position: [0, 0, 1]}]\n");
  const std::string study =
      files.written("study.yaml", "runs: 5\nvary: {\"bodies.ball.position[2]\": {list: [1, 2]}}\n");
  const test::Outcome run = test::sweep(scene + " " + study + " --run 3 --out " + files.path(""));
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_NE(run.out.find("run_3.yaml and a file that the scene names are the same file"),
            std::string::npos)
      << run.out;
  EXPECT_EQ(fileText(files.path("run_3.yaml")), robot);
}

}  // namespace rigid_body_sim
