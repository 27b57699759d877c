#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tools/sweep/sweep_bench.hpp"
#include "tools/sweep/sweep_info.hpp"

namespace rigid_body_sim {
namespace {

using test::fileText;
using test::sweep;

const std::string kBallStudy = R"(runs: 300
seed: 3
vary:
  bodies.ball.mass: {normal: {mean: 2, stddev: 0.1}}
  bodies.ball.orientation: {rotation: {}}
  wrenches[0].duration: {list: [0.5, 1]}
  tolerance: {grid: [1e-3, 1e-9]}
)";

/// What a sweep writes, file by file.
std::string everythingIn(const std::string& directory) {
  std::string all;
  for (const char* name : {"/runs.csv", "/fan.csv", "/summary.csv", "/sweep.svg"})
    all += fileText(directory + name);
  return all;
}

}  // namespace

TEST(SweepProgram, GivesTheSameBytesWithAnyThreadsAndShards) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml", kBallStudy);
  const auto into = [&](const std::string& name, const std::string& options) {
    return sweep(scene + " " + study + " --out " + files.path(name) + " " + options);
  };
  ASSERT_EQ(into("one", "--threads 1").exit_code, 0);
  const std::string one = everythingIn(files.path("one"));
  const std::string rows = fileText(files.path("one/runs.csv"));
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 601);
  for (const char* threads : {"2", "7"}) {
    ASSERT_EQ(into(threads, std::string("--threads ") + threads).exit_code, 0);
    EXPECT_TRUE(everythingIn(files.path(threads)) == one) << threads;
  }
  for (const char* shard : {"3", "1", "4", "2"})
    ASSERT_EQ(into("shards", std::string("--shard ") + shard + "/4").exit_code, 0);
  ASSERT_EQ(sweep("merge " + files.path("shards")).exit_code, 0);
  EXPECT_TRUE(everythingIn(files.path("shards")) == one);
  ASSERT_EQ(into("whole", "--shard 1/1").exit_code, 0);
  EXPECT_TRUE(everythingIn(files.path("whole")) == one);
}

TEST(SweepProgram, MergesDirectoriesOfLaunchedShards) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml", kBallStudy);
  const std::string command = scene + " " + study + " --out ";
  ASSERT_EQ(sweep(command + files.path("one")).exit_code, 0);
  const std::vector<std::pair<std::string, std::string>> launchers = {
      {"slurm",
       "SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_MIN=5 SLURM_ARRAY_TASK_STEP=3 "
       "SLURM_ARRAY_TASK_ID="},
      {"mpi", "OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK="},
      {"pmi", "PMI_SIZE=2 PMI_RANK="},
      {"parallel", "RIGID_BODY_SIM_SHARDS=2 PARALLEL_SEQ="}};
  const std::vector<std::pair<int, int>> numbers = {{5, 8}, {0, 1}, {0, 1}, {1, 2}};
  for (std::size_t i = 0; i < launchers.size(); ++i) {
    const auto& [name, variables] = launchers[i];
    const test::Outcome second =
        sweep(command + files.path(name + "_2"), variables + std::to_string(numbers[i].second));
    ASSERT_EQ(second.exit_code, 0);
    EXPECT_EQ(second.out.find("shard 2 of 2 ("), 0U) << second.out;
    ASSERT_EQ(sweep(command + files.path(name + "_1"), variables + std::to_string(numbers[i].first))
                  .exit_code,
              0);
    ASSERT_EQ(sweep("merge " + files.path(name + "_2") + " " + files.path(name + "_1") + " --out " +
                    files.path(name))
                  .exit_code,
              0);
    EXPECT_TRUE(everythingIn(files.path(name)) == everythingIn(files.path("one"))) << name;
  }
}

TEST(SweepProgram, GoesOnWhereItWasInterrupted) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml", kBallStudy);
  const std::string command = scene + " " + study + " --out ";
  ASSERT_EQ(sweep(command + files.path("one")).exit_code, 0);
  const std::string one = everythingIn(files.path("one"));
  const std::string rows = fileText(files.path("one/runs.csv"));
  // as a crash leaves it: the tables at different rows, the last of them cut
  for (const std::size_t kept :
       {rows.size() / 3, rows.find('\n') + 1, std::size_t{20}, rows.size()}) {
    ASSERT_EQ(sweep(command + files.path("again")).exit_code, 0);
    files.written("again/runs.csv", rows.substr(0, kept));
    const std::string fan = fileText(files.path("one/fan.csv"));
    files.written("again/fan.csv", fan.substr(0, fan.size() / 4));
    const test::Outcome run = sweep(command + files.path("again") + " --resume --threads 2");
    ASSERT_EQ(run.exit_code, 0) << run.out;
    EXPECT_TRUE(everythingIn(files.path("again")) == one) << kept;
  }
}

TEST(SweepProgram, LeavesWholeRowsWhenInterrupted) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml", kBallStudy);
  const std::string runs = " --runs 3000000 --threads 2 --out " + files.path("out");
  // where the tests run in the background of a shell, it would be ignored
  std::signal(SIGINT, SIG_DFL);
  // as soon as there are rows
  const test::Outcome stopped =
      test::runCommand("bash -c 'set -m; " RIGID_BODY_SIM_SWEEP " " + scene + " " + study + runs +
                       " 2>&1 & until [ $(wc -l <" + files.path("out/runs.csv") +
                       " 2>/dev/null || echo 0) -gt 100 ] || ! kill -0 $!; do sleep 0.01; done "
                       "2>/dev/null; kill -INT $!; wait $!'");
  EXPECT_EQ(stopped.exit_code, 128 + 2) << stopped.out;
  EXPECT_NE(stopped.out.find("with --resume goes on"), std::string::npos) << stopped.out;
  const std::string rows = fileText(files.path("out/runs.csv"));
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.back(), '\n');
  const auto table = test::tableAt(files.path("out/runs.csv"));
  EXPECT_EQ(table.at("run").back(), std::to_string(table.at("run").size() - 1));
}

TEST(SweepProgram, KeepsWholeRowsWhenTheDiskIsFull) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml", kBallStudy);
  const std::string command =
      RIGID_BODY_SIM_SWEEP " " + scene + " " + study + " --threads 2 --out ";
  const test::Outcome full =
      test::runCommand("bash -c 'ulimit -f 48; " + command + files.path("out") + " 2>&1'");
  EXPECT_EQ(full.exit_code, 1) << full.out;
  EXPECT_EQ(full.out.find("sweep: " + files.path("out/")), 0U) << full.out;
  EXPECT_NE(full.out.find(".csv: cannot be written: File too large; rows that are written are "
                          "kept: once it can be written, the same command with --resume goes on\n"),
            std::string::npos)
      << full.out;
  EXPECT_EQ(std::count(full.out.begin(), full.out.end(), '\n'), 1) << full.out;
  const std::string rows = fileText(files.path("out/runs.csv"));
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.back(), '\n');
  const auto info = tableInfoIn(fileText(files.path("out/runs.info")));
  ASSERT_TRUE(info);
  // all that both tables have
  const std::string fan = fileText(files.path("out/fan.csv"));
  ASSERT_FALSE(fan.empty());
  EXPECT_EQ(fan.back(), '\n');
  EXPECT_EQ(info->ledger.rows + 1, std::min(std::count(rows.begin(), rows.end(), '\n'),
                                            std::count(fan.begin(), fan.end(), '\n')));
  ASSERT_EQ(sweep(scene + " " + study + " --resume --out " + files.path("out")).exit_code, 0);
  ASSERT_EQ(sweep(scene + " " + study + " --out " + files.path("one")).exit_code, 0);
  EXPECT_TRUE(everythingIn(files.path("out")) == everythingIn(files.path("one")));
}

TEST(SweepProgram, WritesADivergedRunAndARefusedOneAsRows) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(time_step: 0.5
horizon: 1
bodies: [{name: rocket, shape: {sphere: {radius: 1}}, mass: 1}]
wrenches: [{body: rocket, frame: world, force: [1.0e300, 0, 0], start: 0, duration: 1000}]
)");
  const std::string study = files.written("study.yaml", R"(runs: 12
vary:
  bodies.rocket.mass: {list: [1, 1.0e-300]}
  wrenches[0].start: {normal: {mean: 0.2, stddev: 0.4}}
record: {far: {at_end: rocket.px}}
)");
  const test::Outcome run = sweep(scene + " " + study + " --out " + files.path("out"));
  EXPECT_EQ(run.exit_code, 0) << run.out;
  const auto table = test::tableAt(files.path("out/runs.csv"));
  const auto& status = table.at("status");
  ASSERT_EQ(status.size(), 12U);
  int done = 0, diverged = 0, refused = 0;
  for (std::size_t i = 0; i < status.size(); ++i) {
    EXPECT_EQ(table.at("run")[i], std::to_string(i));
    done += status[i] == "done";
    diverged += status[i].rfind("diverged: ", 0) == 0;
    refused += status[i].find("start must be >= 0 s") != std::string::npos;
    EXPECT_EQ(table.at("far")[i].empty(), status[i] != "done");
  }
  EXPECT_GT(done, 0);
  EXPECT_GT(refused, 0);
  EXPECT_GT(diverged, 0);
  EXPECT_EQ(done + diverged + refused, 12);
  EXPECT_EQ(run.out.find("sweep: notice: " + std::to_string(12 - done) + " runs have no result"),
            0U)
      << run.out;
  EXPECT_EQ(fileText(files.path("out/runs.csv")).find("nan"), std::string::npos);
}

TEST(SweepProgram, WritesTheSceneOfARun) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml", kBallStudy);
  const std::string command = scene + " " + study + " --out " + files.path("out");
  ASSERT_EQ(sweep(command).exit_code, 0);
  const test::Outcome written = sweep("--run 7 " + command);
  EXPECT_EQ(written.out, files.path("out/run_7.yaml") + "\n");
  ASSERT_EQ(test::runCommand(RIGID_BODY_SIM_SIMULATE " " + files.path("out/run_7.yaml") +
                             " --sample 2 --csv " + files.path("end.csv") + " >/dev/null")
                .exit_code,
            0);
  const auto end = test::tableAt(files.path("end.csv"));
  const auto rows = test::tableAt(files.path("out/runs.csv"));
  for (const char* quantity : {"px", "pz", "qx", "qw", "vx", "vz", "wz"})
    EXPECT_NEAR(std::stod(end.at(quantity).back()),
                std::stod(rows.at(std::string("ball.") + quantity)[7]), 1e-13)
        << quantity;
  // `simulate` has to be told what the study says of the duration
  const std::string shorter =
      files.written("shorter.yaml", std::string(kBallStudy) + "\nduration: 1.5\n");
  ASSERT_EQ(sweep("--run 8 " + scene + " " + shorter + " --out " + files.path("out")).exit_code, 0);
  const std::string text = fileText(files.path("out/run_8.yaml"));
  EXPECT_NE(text.substr(0, text.find('\n')).find("simulate --duration 1.5"), std::string::npos)
      << text;
  EXPECT_EQ(sweep("--run 600 " + command).exit_code, 2);
}

TEST(SweepProgram, OverwritesNeitherSceneNorStudy) {
  const TemporaryDirectory files;
  const std::string scene = files.written("run_3.yaml", test::kPushedBall);
  const std::string study = files.written("runs.1of2.csv", kBallStudy);
  const std::string command = scene + " " + study + " --out " + files.path("");
  for (const char* options : {" --run 3", " --shard 1/2"}) {
    const test::Outcome run = sweep(command + options);
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_NE(run.out.find("are the same file"), std::string::npos) << run.out;
    EXPECT_EQ(fileText(scene), test::kPushedBall);
    EXPECT_EQ(fileText(study), kBallStudy);
  }
  EXPECT_EQ(sweep(command + " --run 4").exit_code, 0);
}

TEST(EveryShippedStudy, VariesTheSceneThatItNames) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(RIGID_BODY_SIM_CONFIG "/studies")) {
    SCOPED_TRACE(file.path().string());
    ++count;
    const std::string text = fileText(file.path().string());
    EXPECT_EQ(text.substr(0, 2), "# ");
    const std::string head = "For config/";
    const std::size_t begin = text.find(head) + head.size(), end = text.find(".yaml", begin) + 5;
    ASSERT_LT(begin, end);
    const TemporaryDirectory files;
    const test::Outcome run =
        sweep("--run 1 " RIGID_BODY_SIM_CONFIG "/" + text.substr(begin, end - begin) + " " +
              file.path().string() + " --out " + files.path("out"));
    EXPECT_EQ(run.exit_code, 0) << run.out;
  }
  EXPECT_GE(count, 4);
}

TEST(SweepProgram, MergesNothingThatIsNotWhole) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study = files.written("study.yaml", kBallStudy);
  const std::string out = files.path("out"), command = scene + " " + study + " --out " + out;
  EXPECT_EQ(sweep("merge " + out).out, "sweep: " + out + ": is no directory\n");
  ASSERT_EQ(sweep(command + " --shard 1/2").exit_code, 0);
  EXPECT_EQ(sweep("merge " + out).out, "sweep: runs.2of2.csv: this shard is missing\n");
  ASSERT_EQ(sweep(command + " --shard 2/2 --seed 4").exit_code, 0);
  EXPECT_EQ(
      sweep("merge " + out).out,
      "sweep: " + out + "/runs.2of2.csv: is of another sweep than " + out + "/runs.1of2.csv\n");
  ASSERT_EQ(sweep(command + " --shard 2/2").exit_code, 0);
  const std::string rows = fileText(out + "/runs.2of2.csv");
  files.written("out/runs.2of2.csv", rows.substr(0, rows.size() / 2));
  EXPECT_NE(sweep("merge " + out).out.find("of 300 rows; finish it with --resume"),
            std::string::npos);
  EXPECT_FALSE(std::ifstream(out + "/runs.csv").good());
  ASSERT_EQ(sweep(command + " --shard 2/2 --resume").exit_code, 0);
  const std::string fan = fileText(out + "/fan.2of2.csv");
  files.written("out/fan.2of2.csv", fan.substr(0, fan.size() / 2));
  EXPECT_NE(sweep("merge " + out).out.find("fan.2of2.csv: has "), std::string::npos);
  EXPECT_FALSE(std::ifstream(out + "/fan.csv").good());
}

}  // namespace rigid_body_sim
