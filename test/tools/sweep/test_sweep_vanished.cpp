#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tools/sweep/run_table.hpp"
#include "tools/sweep/sweep_bench.hpp"

/// Files that are taken away or cut off while they are written, and sweeps that are stopped.
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
    EXPECT_EQ(faultOf(table),
              path +
                  ": was removed, moved or replaced while this sweep wrote it; put "
                  "it back, and the same command with --resume goes on, or begin anew")
        << how;
    EXPECT_THROW(table.requireInPlace(), std::runtime_error);
  }
}

TEST(LockedFile, IsOpenOnce) {
  const TemporaryDirectory files;
  const std::string path = files.path("runs.csv");
  {
    LockedFile first(path);
    EXPECT_TRUE(first.isNew());
    EXPECT_THROW(LockedFile{path}, std::runtime_error);
    const LockedFile moved = std::move(first);
    EXPECT_THROW(LockedFile{path}, std::runtime_error);
  }
  EXPECT_FALSE(LockedFile(path).isNew());
}

TEST(RunTable, TakesNoRowsBehindThoseOfAnother) {
  for (const char* how :
       {": >FILE", "head -c 6 FILE >FILE.new; cat FILE.new >FILE", "echo 3,4 >>FILE"}) {
    const TemporaryDirectory files;
    const std::string path = files.path("runs.csv");
    RunTable table = RunTable::create(LockedFile(path), "run,a");
    EXPECT_EQ(faultOf(table), "");
    EXPECT_NO_THROW(table.requireInPlace());
    std::string command = how;
    for (std::size_t at; (at = command.find("FILE")) != std::string::npos;)
      command.replace(at, 4, path);
    ASSERT_EQ(test::runCommand(command).exit_code, 0);
    const std::string left = test::fileText(path);
    EXPECT_EQ(faultOf(table),
              path +
                  ": was cut or added to by another program while this sweep wrote it; the same "
                  "command with --resume goes on with what is left of it")
        << how;
    EXPECT_THROW(table.requireInPlace(), std::runtime_error);
    EXPECT_EQ(test::fileText(path), left);
  }
}

// In the middle of a sweep, which ends at its next write.
TEST(SweepProgram, EndsAsSoonAsItsTablesAreNotInPlace) {
  const std::pair<std::string, std::string> faults[] = {
      {"rm -r OUT", "removed, moved or replaced"},
      {"rm OUT/runs.csv", "removed, moved or replaced"},
      {"rm OUT/fan.csv", "removed, moved or replaced"},
      {": >OUT/runs.csv", "cut or added to by another program"},
      {"truncate -s 100 OUT/fan.csv", "cut or added to by another program"}};
  for (const auto& [how, was] : faults) {
    const TemporaryDirectory files;
    const std::string scene = files.written("scene.yaml", test::kPushedBall),
                      out = files.path("out");
    const std::string study =
        files.written("study.yaml", "runs: 50000000\nvary: {bodies.ball.mass: {uniform: [1, 2]}}");
    std::string command = how;
    command.replace(command.find("OUT"), 3, out);
    const test::Outcome run = test::runCommand(
        "bash -c '" RIGID_BODY_SIM_SWEEP " " + scene + " " + study + " --out " + out +
        " 2>&1 & until [ $(wc -l <" + out +
        "/runs.csv 2>/dev/null || echo 0) -gt 100 ] || ! kill -0 $!; do sleep 0.01; done "
        "2>/dev/null; " +
        command + "; wait $!'");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.out.find(": was " + was + " while this sweep wrote it"), std::string::npos)
        << run.out;
  }
}

TEST(SweepProgram, LeavesNoSummaryThatIsNotWhole) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  // a summary of many columns, beside few rows
  std::string study = "runs: 2\nvary: {bodies.ball.mass: {list: [1, 2]}}\nrecord:\n";
  for (int i = 0; i < 280; ++i) study += "  r" + std::to_string(i) + ": {at_end: ball.px}\n";
  const std::string command =
      scene + " " + files.written("study.yaml", study) + " --out " + files.path("out");
  ASSERT_EQ(test::sweep(command, "PATH=/nonexistent").exit_code, 0);
  const std::string summary = files.path("out/summary.csv"), whole = test::fileText(summary);
  ASSERT_GT(whole.size(), 16384U);
  ASSERT_EQ(remove(summary.c_str()), 0);
  const test::Outcome full = test::runCommand(
      "bash -c 'ulimit -f 16; PATH=/nonexistent " RIGID_BODY_SIM_SWEEP " " + command + " 2>&1'");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_EQ(full.out,
            "sweep: " + summary +
                ": cannot be written: File too large; all runs are in runs.csv: once "
                "it can be written, the same command makes it, of a sweep with --resume\n");
  EXPECT_FALSE(std::ifstream(summary).good());
  EXPECT_FALSE(std::ifstream(summary + ".unfinished").good());
  EXPECT_EQ(test::sweep(command + " --resume", "PATH=/nonexistent").exit_code, 0);
  EXPECT_EQ(test::fileText(summary), whole);
}

// A second signal would end it at once.
TEST(SweepProgram, SaysThatItStopsWhenLongRunsAreUnderWay) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", "integrator: rk4\n" + test::kPushedBall);
  const std::string study = files.written(
      "study.yaml", "runs: 4\nduration: 10000000\nvary: {bodies.ball.mass: {uniform: [1, 2]}}");
  const std::string out = files.path("out"), said = files.path("said");
  const auto wait = [](const std::string& condition) {
    return "until " + condition + " || ! kill -0 $!; do sleep 0.01; done 2>/dev/null; ";
  };
  const test::Outcome run = test::runCommand(
      "bash -c 'set -m; " RIGID_BODY_SIM_SWEEP " " + scene + " " + study + " --threads 1 --out " +
      out + " 2>" + said + " & " + wait("[ -s " + out + "/runs.csv ]") + "kill -INT $!; " +
      wait("grep -q stopping " + said) + "kill -INT $!; wait $!' 2>/dev/null");
  EXPECT_EQ(run.exit_code, 128 + 2);
  const std::string text = test::fileText(said);
  EXPECT_EQ(text.find("sweep: stopping when the runs under way have ended; once more, and it ends "
                      "at once without them"),
            0U)
      << text;
}

}  // namespace rigid_body_sim
