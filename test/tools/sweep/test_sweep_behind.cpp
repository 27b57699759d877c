#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/sweep/merge_shards.hpp"
#include "tools/sweep/shard.hpp"
#include "tools/sweep/sweep_bench.hpp"
#include "tools/sweep/sweep_info.hpp"
#include "tools/sweep/sweep_summary.hpp"

/// What is behind the rows of a table, and sweeps and merges that end before they are done.
namespace rigid_body_sim {
namespace {

struct EndedSweep : test::SweepFiles {
  EndedSweep()
      : SweepFiles(test::kPushedBall, "runs: 400\nvary: {bodies.ball.mass: {uniform: [1, 2]}}") {}

  test::Outcome sweep(const std::string& options = "", const std::string& before = "") const {
    return sweepAfter(before, options);
  }
};

/// Two shards of as many runs, with one value each; what a merge of them would replace.
void writeShards(const TemporaryDirectory& files, std::int64_t runs) {
  const std::string header = "run,a,attitude_error,position_error,status";
  for (std::int64_t index = 1; index <= 2; ++index) {
    const Shard shard{index, 2};
    TableInfo info;
    info.sweep.runs = runs;
    info.sweep.varied = 1;
    std::string text = header + "\n";
    for (std::int64_t j = 0; j < shard.runsOf(runs); ++j) {
      const std::string row = std::to_string(shard.run(j)) + ",1.5,0,0,done";
      text += row + "\n";
      info.ledger.digest += digestOfRow(row);
      ++info.ledger.rows;
    }
    files.written("out/" + shard.fileName("runs", ".csv"), text);
    files.written("out/" + shard.fileName("runs", ".info"), toText(info));
  }
}

}  // namespace

TEST(SweepProgram, RefusesWhatIsBehindTheLastRow) {
  const EndedSweep bench;
  ASSERT_EQ(bench.sweep().exit_code, 0);
  for (const std::string name : {"runs", "fan"}) {
    const std::string path = bench.out + "/" + name + ".csv", whole = test::fileText(path);
    for (const char* behind : {"400,garbage\n", "400,1.2", "\n"}) {
      bench.files.written("out/" + name + ".csv", whole + behind);
      const std::string refusal = "sweep: " + path +
                                  ": has more than the 400 rows of its runs; somebody has changed "
                                  "the table: remove what is behind them, or make its runs anew\n";
      EXPECT_EQ(bench.sweep("--resume").out, refusal) << behind;
      EXPECT_EQ(test::sweep("merge " + bench.out).out, refusal) << behind;
      EXPECT_EQ(test::fileText(path), whole + behind);
    }
    bench.files.written("out/" + name + ".csv", whole);
  }
  EXPECT_EQ(bench.sweep("--resume").exit_code, 0);
}

// As a process leaves it that is killed before it writes of its last rows.
TEST(SweepProgram, SaysWhatItMakesAgainThatIsNotInItsDescription) {
  const EndedSweep bench;
  ASSERT_EQ(bench.sweep().exit_code, 0);
  const std::string whole = test::fileText(bench.table);
  const std::string info = test::fileText(bench.out + "/runs.info");
  const auto behind = [&](const std::string& text) {
    bench.files.written("out/runs.csv", text);
    const std::string said = bench.sweep("--resume").out;
    EXPECT_EQ(test::fileText(bench.table), whole);
    EXPECT_EQ(test::fileText(bench.out + "/runs.info"), info);
    return said.substr(0, said.find('\n') + 1);
  };
  std::filesystem::remove_all(bench.out);
  ASSERT_EQ(bench.sweep("", "ulimit -f 40;").exit_code, 1);
  const std::string text = test::fileText(bench.table);
  const std::int64_t rows = tableInfoIn(test::fileText(bench.out + "/runs.info"))->ledger.rows;
  ASSERT_GT(rows, 10);
  const std::size_t end = whole.find("\n" + std::to_string(rows) + ",") + 1;
  EXPECT_EQ(behind(text.substr(0, end) + "mine\nmi"),
            "sweep: notice: " + bench.table + ": its first " + std::to_string(rows) +
                " rows are kept; what is behind them is not in runs.info, and is made again\n");
  TableInfo none = *tableInfoIn(info);
  none.ledger = {};
  bench.files.written("out/runs.info", toText(none));
  EXPECT_EQ(behind(whole), "sweep: notice: " + bench.table +
                               ": its rows are not in runs.info, and are made again\n");
}

// As a process leaves it that is ended while it makes them again: of what it has written nothing is
// known until all of it is there.
TEST(SweepProgram, MakesTheRowsOfAFanAgainThatItsDescriptionDoesNotKnow) {
  const EndedSweep bench;
  ASSERT_EQ(bench.sweep().exit_code, 0);
  const std::string path = bench.out + "/fan.csv", rows = test::fileText(bench.table);
  const std::string fan = test::fileText(path), info = test::fileText(bench.out + "/runs.info");
  const auto rowsBefore = [](const std::string& text, int run) {
    return text.substr(0, text.find("\n" + std::to_string(run) + ",") + 1);
  };
  bench.files.written("out/runs.csv", rowsBefore(rows, 300));
  // the fan has more bytes than the rows, and is made again first
  const int room = static_cast<int>(rowsBefore(fan, 100).size() / 1024);
  ASSERT_EQ(bench.sweep("--resume", "ulimit -f " + std::to_string(room) + ";").exit_code, 1);
  const TableInfo there = tableInfoIn(test::fileText(bench.out + "/runs.info")).value();
  EXPECT_EQ(there.ledger.rows, 300);
  EXPECT_FALSE(there.ledger.knowsFan());
  bench.files.written("out/fan.csv", rowsBefore(fan, 300));
  const test::Outcome again = bench.sweep("--resume");
  EXPECT_EQ(again.exit_code, 0) << again.out;
  EXPECT_EQ(again.out.find("sweep: notice: " + path +
                           ": its rows are not in runs.info, and are made again\n"),
            0U)
      << again.out;
  EXPECT_EQ(test::fileText(bench.table), rows);
  EXPECT_EQ(test::fileText(path), fan);
  EXPECT_EQ(test::fileText(bench.out + "/runs.info"), info);
  // of all runs, too
  TableInfo unknown = *tableInfoIn(info);
  unknown.ledger.fan_digest = 0;
  bench.files.written("out/runs.info", toText(unknown));
  EXPECT_EQ(test::sweep("merge " + bench.out).out,
            "sweep: " + path +
                ": its rows were made again, and that was ended before runs.info had them; finish "
                "it with --resume\n");
  EXPECT_EQ(bench.sweep("--resume").exit_code, 0);
  EXPECT_EQ(test::fileText(bench.out + "/runs.info"), info);
}

TEST(SweepProgram, PromisesNothingWhereNothingIsWritten) {
  const EndedSweep bench;
  EXPECT_EQ(bench.sweep("", "ulimit -f 0;").out,
            "sweep: " + bench.out + "/runs.info: cannot be written: File too large\n");
}

// By as many bytes as there were, which its length does not tell; requireLedger refuses such rows.
TEST(SweepProgram, SummarisesNoRowsThatWereChangedMeanwhile) {
  const EndedSweep bench;
  ASSERT_EQ(bench.sweep().exit_code, 0);
  const std::optional<TableInfo> info = tableInfoIn(test::fileText(bench.out + "/runs.info"));
  ASSERT_TRUE(info.has_value());
  EXPECT_EQ(summarise(bench.table, info->sweep).digest, info->ledger.digest);
  std::string rows = test::fileText(bench.table);
  const std::size_t digit = rows.find_first_of("12345678", rows.find("\n100,") + 6);
  ++rows[digit];
  std::ofstream(bench.table) << rows;
  EXPECT_NE(summarise(bench.table, info->sweep).digest, info->ledger.digest);
}

TEST(MergeShards, LeavesWhatWasThereWhereItIsStopped) {
  const TemporaryDirectory files;
  std::filesystem::create_directory(files.path("out"));
  writeShards(files, 10);
  const auto merged = [&](bool stop) {
    return mergeShards({files.path("out")}, files.path("out"), std::atomic<bool>(stop));
  };
  EXPECT_FALSE(merged(true));
  for (const char* name : {"runs.csv", "runs.csv.part", "runs.info"})
    EXPECT_FALSE(std::filesystem::exists(files.path("out/") + name)) << name;
  ASSERT_TRUE(merged(false));
  const std::string rows = test::fileText(files.path("out/runs.csv"));
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 11);
  EXPECT_FALSE(merged(true));
  EXPECT_EQ(test::fileText(files.path("out/runs.csv")), rows);
}

// At whatever moment: either it was in time, and nothing is left, or it is done.
TEST(SweepProgram, SaysThatAMergeIsStopped) {
  const TemporaryDirectory files;
  std::filesystem::create_directory(files.path("out"));
  writeShards(files, 400000);
  const test::Outcome stopped = test::runCommand(
      "bash -c 'set -m; PATH=/nonexistent " RIGID_BODY_SIM_SWEEP " merge " + files.path("out") +
      " 2>&1 >/dev/null & until [ -e " + files.path("out/runs.csv.part") +
      " ] || ! kill -0 $!; do :; done 2>/dev/null; kill -INT $!; wait $!' 2>/dev/null");
  EXPECT_FALSE(std::filesystem::exists(files.path("out/runs.csv.part")));
  const bool is_merged = std::filesystem::exists(files.path("out/runs.csv"));
  if (!is_merged) {
    EXPECT_EQ(stopped.exit_code, 128 + 2);
    EXPECT_EQ(stopped.out, "sweep: stopped: nothing is merged, and what was there is as it was\n");
  }
  EXPECT_EQ(std::filesystem::exists(files.path("out/runs.info")), is_merged);
}

}  // namespace rigid_body_sim
