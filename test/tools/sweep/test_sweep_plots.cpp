#include <csignal>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tools/sweep/sweep_bench.hpp"

/// What is made of a table that is whole: where it cannot be written, or is not waited for.
namespace rigid_body_sim {

using test::sweep;

namespace {
const std::string kFiveRuns = "runs: 5\nvary: {bodies.ball.mass: {uniform: [1, 2]}}";
}  // namespace

TEST(SweepProgram, SaysWhereThePlotCannotBeWritten) {
  const test::SweepFiles of_sweep(test::kPushedBall, kFiveRuns);
  const TemporaryDirectory& files = of_sweep.files;
  const std::string svg = of_sweep.out + "/sweep.svg";
  const std::string command = of_sweep.command();
  ASSERT_EQ(test::runCommand("mkdir -p " + svg).exit_code, 0);
  const auto lastLine = [](const std::string& text) {
    return text.substr(text.rfind('\n', text.size() - 2) + 1);
  };
  const test::Outcome taken = sweep(command);
  EXPECT_EQ(taken.exit_code, 1);
  EXPECT_EQ(taken.out, "sweep: " + svg + ": is no regular file\n");
  ASSERT_EQ(test::runCommand("rmdir " + svg).exit_code, 0);
  // of all files the plot alone has more than 16 kB
  const test::Outcome full =
      test::runCommand("bash -c 'ulimit -f 16; " RIGID_BODY_SIM_SWEEP " " + command + " 2>&1'");
  EXPECT_EQ(full.exit_code, 1) << full.out;
  EXPECT_EQ(lastLine(full.out),
            "sweep: " + svg +
                ": cannot be written: File too large; all runs are in runs.csv: once it can be "
                "written, the same command makes it, of a sweep with --resume\n");
  EXPECT_FALSE(std::ifstream(svg).good());
  EXPECT_EQ(sweep(command).exit_code, 0);
  // what is there is replaced, as the summary is, whatever it allows
  const std::string picture = test::fileText(svg);
  for (const char* name : {"sweep.svg", "summary.csv"})
    ASSERT_EQ(chmod(files.path(std::string("out/") + name).c_str(), S_IRUSR), 0);
  EXPECT_EQ(sweep(command + " --resume").exit_code, 0);
  EXPECT_EQ(test::fileText(svg), picture);
}

// A gnuplot that ends the process which has started it.
TEST(SweepProgram, SaysThatItIsStoppedBesideAWholeTable) {
  const test::SweepFiles of_sweep(test::kPushedBall, kFiveRuns);
  const TemporaryDirectory& files = of_sweep.files;
  const std::string out = of_sweep.out, gnuplot = files.path("gnuplot");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::signal(signal, SIG_DFL);
    files.written("gnuplot", "#!/bin/sh\nkill -" + std::to_string(signal) + " $SWEEP\n");
    ASSERT_EQ(chmod(gnuplot.c_str(), S_IRWXU), 0);
    const auto ended = [&](const std::string& arguments) {
      return test::runCommand("bash -c '(SWEEP=$BASHPID; export SWEEP; PATH=" + files.path("") +
                              ":$PATH exec " RIGID_BODY_SIM_SWEEP " " + arguments +
                              " >/dev/null 2>" + files.path("said") + "); code=$?; cat " +
                              files.path("said") + "; exit $code' 2>/dev/null");
    };
    const test::Outcome run = ended(of_sweep.command());
    EXPECT_EQ(run.exit_code, 128 + signal);
    EXPECT_EQ(run.out,
              "sweep: stopped: all runs are in runs.csv, and the same command with --resume makes "
              "summary and plot\n");
    const test::Outcome merged = ended("merge " + out);
    EXPECT_EQ(merged.exit_code, 128 + signal);
    EXPECT_EQ(merged.out,
              "sweep: stopped: the shards are merged, and the same command makes summary and "
              "plot\n");
    EXPECT_TRUE(std::ifstream(out + "/summary.csv").good());
    EXPECT_FALSE(std::ifstream(out + "/sweep.svg").good());
  }
}

}  // namespace rigid_body_sim
