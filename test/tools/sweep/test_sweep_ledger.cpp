#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tools/sweep/sweep_bench.hpp"
#include "tools/sweep/sweep_info.hpp"

/// What stands beside a table of its rows.
namespace rigid_body_sim {
namespace {

constexpr const char* kWithoutPlot = "PATH=/nonexistent";

std::optional<TableInfo> infoIn(const std::string& directory, const std::string& name = "runs") {
  return tableInfoIn(test::fileText(directory + "/" + name + ".info"));
}

/// A sweep whose runs have a doubtful error, but those whose masses are refused.
struct DoubtfulSweep : test::SweepFiles {
  DoubtfulSweep()
      : SweepFiles(test::kDoubtfulBall,
                   "runs: 12\nseed: 2\nvary: {bodies.ball.mass: {uniform: [-0.2, 1]}}") {}

  test::Outcome sweep(const std::string& directory, const std::string& options = "") const {
    return test::sweep(scene + " " + study + " --out " + files.path(directory) + " " + options,
                       kWithoutPlot);
  }
};

/// The lines of the notices.
std::string noticesIn(const std::string& text) {
  std::istringstream lines(text);
  std::string line, notices;
  while (std::getline(lines, line))
    if (line.find("notice") != std::string::npos) notices += line + "\n";
  return notices;
}

}  // namespace

TEST(SweepLedger, IsTheSameInAnyOrder) {
  SweepLedger parts[3], whole;
  for (std::int64_t run = 0; run < 30; ++run) {
    const std::string row = std::to_string(run) + ",1.5,done";
    for (SweepLedger* ledger : {&parts[run % 3], &whole}) {
      ++ledger->rows;
      ledger->digest += digestOfRow(row);
      if (run % 7 == 2) ledger->addDoubt(run, "why " + std::to_string(run));
      if (run % 5 == 4) ledger->refused.add(run, "refused: " + std::to_string(run));
    }
  }
  SweepLedger sum;
  for (const int i : {2, 0, 1}) sum.add(parts[i]);
  SweepInfo sweep;
  sweep.runs = 30;
  const std::string text = toText(TableInfo{sweep, whole});
  EXPECT_EQ(toText(TableInfo{sweep, sum}), text);
  EXPECT_EQ(whole.doubtful_runs, (std::vector<std::int64_t>{2, 9, 16, 23}));
  const auto back = tableInfoIn(text);
  ASSERT_TRUE(back);
  EXPECT_EQ(toText(*back), text);
  EXPECT_FALSE(tableInfoIn(text.substr(0, text.find("doubtful_runs"))));
}

TEST(SweepLedger, NamesAsManyRunsAsAreOfUse) {
  SweepLedger even, odd;
  for (std::int64_t run = 0; run < 1800; ++run) (run % 2 == 0 ? even : odd).addDoubt(run, "why");
  odd.add(even);
  EXPECT_EQ(odd.doubtful.count, 1800);
  EXPECT_EQ(odd.doubtful.first, 0);
  ASSERT_EQ(odd.doubtful_runs.size(), 1000U);
  EXPECT_EQ(odd.doubtful_runs.back(), 999);
}

// Every byte counts, at every place of a word.
TEST(SweepLedger, TellsRowsApart) {
  const std::string row = "12,2.0000000000000004,0.1,,done";
  for (std::size_t i = 0; i < row.size(); ++i) {
    std::string other = row;
    other[i] ^= 1;
    EXPECT_NE(digestOfRow(other), digestOfRow(row)) << i;
    EXPECT_NE(digestOfRow(row.substr(0, i)), digestOfRow(row)) << i;
  }
}

TEST(SweepProgram, SaysOfTheWholeTableWhichRunsAreDoubtful) {
  const DoubtfulSweep bench;
  const test::Outcome whole = bench.sweep("one");
  ASSERT_EQ(whole.exit_code, 0) << whole.out;
  const std::string notices = noticesIn(whole.out);
  EXPECT_EQ(std::count(notices.begin(), notices.end(), '\n'), 2) << notices;
  const auto info = infoIn(bench.files.path("one"));
  ASSERT_TRUE(info);
  const auto table = test::tableAt(bench.files.path("one/runs.csv"));
  std::vector<std::int64_t> done;
  for (std::size_t run = 0; run < 12; ++run)
    if (table.at("status")[run] == "done") done.push_back(static_cast<std::int64_t>(run));
  EXPECT_EQ(info->ledger.doubtful_runs, done);
  EXPECT_EQ(info->ledger.refused.count, 12 - static_cast<std::int64_t>(done.size()));
  // of a table that is there already
  EXPECT_EQ(noticesIn(bench.sweep("one", "--resume").out), notices);
  for (const char* shard : {"3", "1", "2"})
    ASSERT_EQ(bench.sweep("shards", std::string("--shard ") + shard + "/3").exit_code, 0);
  EXPECT_EQ(noticesIn(test::sweep("merge " + bench.files.path("shards"), kWithoutPlot).out),
            notices);
  EXPECT_EQ(test::fileText(bench.files.path("shards/runs.info")),
            test::fileText(bench.files.path("one/runs.info")));
}

TEST(SweepProgram, ChecksEveryRowBeforeARun) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: 9\nvary: {bodies.ball.mass: {uniform: [1, 2]}}");
  const std::string out = files.path("out"), table = out + "/runs.csv";
  const auto swept = [&](const std::string& options) {
    return test::sweep(scene + " " + study + " --out " + out + options, kWithoutPlot);
  };
  ASSERT_EQ(swept("").exit_code, 0);
  const std::string rows = test::fileText(table), fan = test::fileText(out + "/fan.csv");
  const std::size_t row = rows.find("\n3,") + 1, end = rows.find('\n', row);
  const std::string line = rows.substr(row, end - row);
  const std::size_t value = line.find(',') + 1, result = line.find(',', value) + 1;
  const auto edited = [&](std::size_t at, const std::string& text) {
    return line.substr(0, at) + text + line.substr(line.find_first_of(",", at));
  };
  const std::string anew = "'; somebody has changed the table: remove it, and make its runs anew\n";
  const std::string last = line.substr(0, line.rfind(',') + 1);
  const std::vector<std::pair<std::string, std::string>> edits = {
      {edited(value, "abc"), ":5: field 2 must be a number, got 'abc" + anew},
      {edited(result, ""), ":5: field 3 must be a number, got '" + anew},
      {last + "refused: me", ":5: field 3 must be empty, as the run has no result, got '" +
                                 line.substr(result, line.find(',', result) - result) + anew},
      {last + "ok", ":5: status must be done, refused: or diverged: with why, got 'ok" + anew},
      {line + ",1",
       ":5: must have " + std::to_string(std::count(line.begin(), line.end(), ',') + 1) +
           " fields, got '" + std::to_string(std::count(line.begin(), line.end(), ',') + 2) + anew},
      {edited(value, "1.5"),
       ": its rows are not those that were written; somebody has changed the "
       "table: remove it, and make its runs anew\n"}};
  for (const auto& [changed, message] : edits) {
    const std::string text = rows.substr(0, row) + changed + rows.substr(end);
    files.written("out/runs.csv", text);
    const test::Outcome resumed = swept(" --resume");
    EXPECT_EQ(resumed.exit_code, 1);
    EXPECT_EQ(resumed.out, "sweep: " + table + message);
    EXPECT_EQ(test::fileText(table), text);
    if (changed == edits.front().first) continue;  // a word, for all that merge knows
    EXPECT_EQ(test::sweep("merge " + out, kWithoutPlot).out, "sweep: " + table + message);
    EXPECT_FALSE(std::ifstream(table + ".part").good());
    // of a table that has lost its end the form can be checked
    files.written("out/runs.csv", text.substr(0, text.rfind("\n8,") + 1));
    const test::Outcome cut = swept(" --resume");
    if (changed == edits.back().first) {
      EXPECT_EQ(cut.exit_code, 0);
      EXPECT_NE(cut.out.find("with the runs that were lost its rows are not those that were "
                             "written: somebody has changed it, or "),
                std::string::npos)
          << cut.out;
      EXPECT_EQ(cut.out.find("sweep: notice: " + table +
                             ": has lost its last rows, of 9; of the 8 that are left only the form "
                             "could be checked\n"),
                0U)
          << cut.out;
    } else {
      EXPECT_EQ(cut.out, "sweep: " + table + message);
    }
  }
  // without a change nothing is said but that it has lost rows
  files.written("out/runs.csv", rows);
  ASSERT_EQ(swept("").exit_code, 0);
  files.written("out/runs.csv", rows.substr(0, rows.find("\n7,") + 1));
  const std::string made_whole = swept(" --resume").out;
  EXPECT_EQ(made_whole.find("notice"), made_whole.rfind("notice")) << made_whole;
  EXPECT_EQ(test::fileText(table), rows);
  // a result that another has
  files.written("out/runs.csv", rows);
  ASSERT_EQ(swept("").exit_code, 0);
  const std::size_t at = fan.find("\n3,") + 3;
  const std::string changed = fan.substr(0, at) + "7" + fan.substr(fan.find(',', at));
  files.written("out/fan.csv", changed);
  const std::string message = "sweep: " + out +
                              "/fan.csv: its rows are not those that were written; somebody has "
                              "changed the table: remove it, and --resume makes it again\n";
  EXPECT_EQ(swept(" --resume").out, message);
  EXPECT_EQ(test::sweep("merge " + out, kWithoutPlot).out, message);
  EXPECT_EQ(test::fileText(out + "/fan.csv"), changed);
  // its rows alone are made again
  ASSERT_EQ(remove((out + "/fan.csv").c_str()), 0);
  const test::Outcome made = swept(" --resume");
  EXPECT_EQ(
      made.out.find("sweep: notice: " + out + "/fan.csv: has lost rows, which are made again"), 0U)
      << made.out;
  EXPECT_EQ(test::fileText(out + "/fan.csv"), fan);
  EXPECT_EQ(test::fileText(table), rows);
  EXPECT_EQ(swept(" --resume").out.find("notice"), std::string::npos);
}

}  // namespace rigid_body_sim
