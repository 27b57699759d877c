#include <array>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "programs/usage.hpp"
#include "tools/sweep/shard.hpp"
#include "tools/sweep/sweep_bench.hpp"

/// The shard that a launcher sets, and directories that are divided otherwise.
namespace rigid_body_sim {
namespace {

using Variables = std::map<std::string, std::string>;

/// "2/4 by NAME", or what is wrong.
std::string shardIn(const Variables& variables) {
  try {
    const LaunchedShard launched = launchedShard([&](const char* name) {
      const auto found = variables.find(name);
      return found == variables.end() ? nullptr : found->second.c_str();
    });
    return std::to_string(launched.shard.index) + "/" + std::to_string(launched.shard.count) +
           (launched.by.empty() ? "" : " by " + launched.by);
  } catch (const UsageError& error) {
    return error.what();
  }
}

Variables slurm(int id, int first, int last, int count, int step = 1) {
  return {{"SLURM_ARRAY_TASK_ID", std::to_string(id)},
          {"SLURM_ARRAY_TASK_MIN", std::to_string(first)},
          {"SLURM_ARRAY_TASK_MAX", std::to_string(last)},
          {"SLURM_ARRAY_TASK_COUNT", std::to_string(count)},
          {"SLURM_ARRAY_TASK_STEP", std::to_string(step)}};
}

}  // namespace

TEST(LaunchedShard, IsThatOfEveryTaskOfAnArrayOrOfNone) {
  EXPECT_EQ(shardIn(slurm(3, 1, 4, 4)), "3/4 by SLURM_ARRAY_TASK_ID");
  EXPECT_EQ(shardIn(slurm(0, 0, 3, 4)), "1/4 by SLURM_ARRAY_TASK_ID");
  // --array=1-6:2 is 1, 3, 5
  EXPECT_EQ(shardIn(slurm(5, 1, 5, 3, 2)), "3/3 by SLURM_ARRAY_TASK_ID");
  // --array=1,3,7
  for (const int id : {1, 3, 7})
    EXPECT_EQ(shardIn(slurm(id, 1, 7, 3)),
              "environment: the tasks of this array of Slurm are not FIRST-LAST:STEP; "
              "RIGID_BODY_SIM_SHARDS=N makes the task of number I, 1 to N, shard I of N; "
              "--shard I/N does, too");
}

TEST(LaunchedShard, IsTheSameWhereATaskIsRepeated) {
  for (const auto& [id, first, last, count] :
       {std::array{2, 2, 2, 1}, {3, 3, 4, 2}, {7, 1, 7, 3}, {2, 1, 8, 8}}) {
    Variables variables = slurm(id, first, last, count);
    variables["RIGID_BODY_SIM_SHARDS"] = "8";
    EXPECT_EQ(shardIn(variables), std::to_string(id) + "/8 by SLURM_ARRAY_TASK_ID");
  }
  Variables variables = slurm(0, 0, 3, 4);
  variables["RIGID_BODY_SIM_SHARDS"] = "4";
  EXPECT_EQ(
      shardIn(variables),
      "environment: SLURM_ARRAY_TASK_ID makes this shard 0 of 4; --shard I/N says which it is");
}

TEST(LaunchedShard, IsATaskOfAStepOfSlurmOrAProcessOfPmix) {
  // as in a batch script
  EXPECT_EQ(shardIn({{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "4"}}), "1/1");
  EXPECT_EQ(shardIn({{"SLURM_PROCID", "1"}, {"SLURM_STEP_NUM_TASKS", "4"}, {"PMIX_RANK", "1"}}),
            "2/4 by SLURM_PROCID");
  EXPECT_EQ(shardIn({{"PMIX_RANK", "1"}, {"RIGID_BODY_SIM_SHARDS", "2"}}), "2/2 by PMIX_RANK");
  EXPECT_EQ(shardIn({{"PMIX_RANK", "1"}}),
            "environment: RIGID_BODY_SIM_SHARDS must be a whole number up to 100000000, since "
            "PMIX_RANK is set, got nothing; or --shard I/N says which runs are made");
}

TEST(SweepProgram, DividesADirectoryInOneWayOnly) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: 6\nvary: {bodies.ball.mass: {list: [1, 2]}}");
  const std::string command = scene + " " + study + " --out ", out = files.path("out");
  const std::string no_plot = "PATH=/nonexistent ";
  const std::string task = no_plot +
                           "SLURM_ARRAY_TASK_STEP=1 SLURM_ARRAY_TASK_COUNT=1 SLURM_ARRAY_TASK_ID=2 "
                           "SLURM_ARRAY_TASK_MIN=2 SLURM_ARRAY_TASK_MAX=2";
  ASSERT_EQ(test::sweep(command + out + " --shard 1/2", no_plot).exit_code, 0);
  // a task that is repeated
  const test::Outcome whole = test::sweep(command + out, task);
  EXPECT_EQ(whole.exit_code, 1);
  EXPECT_EQ(whole.out, "sweep: " + out +
                           "/runs.1of2.csv: is of shard 1 of 2, and here all runs would be made; "
                           "--shard I/N or RIGID_BODY_SIM_SHARDS=N divides as before, or name "
                           "another --out, or remove it\n");
  EXPECT_EQ(test::sweep(command + out + " --shard 2/3", no_plot).exit_code, 1);
  EXPECT_FALSE(std::ifstream(out + "/runs.csv").good());
  EXPECT_EQ(test::sweep(command + out, task + " RIGID_BODY_SIM_SHARDS=2").exit_code, 0);
  ASSERT_EQ(test::sweep("merge " + out, no_plot).exit_code, 0);
  // beside the merged table, too
  EXPECT_EQ(test::sweep(command + out + " --shard 2/2 --resume", no_plot).exit_code, 0);

  ASSERT_EQ(test::sweep(command + files.path("one"), no_plot).exit_code, 0);
  EXPECT_NE(test::sweep(command + files.path("one") + " --shard 1/2", no_plot)
                .out.find("one/runs.csv: is of all runs, and here shard 1 of 2 would be made; "),
            std::string::npos);
  // a scene is written whatever the launcher says
  EXPECT_EQ(test::sweep(command + out + " --run 3", no_plot + "OMPI_COMM_WORLD_RANK=1").exit_code,
            0);
}

}  // namespace rigid_body_sim
