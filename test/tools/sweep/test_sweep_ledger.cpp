#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

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

/// A sweep of nine runs that is done, and its tables as it wrote them.
struct FinishedSweep : test::SweepFiles {
  FinishedSweep()
      : SweepFiles(test::kPushedBall, "runs: 9\nvary: {bodies.ball.mass: {uniform: [1, 2]}}") {
    EXPECT_EQ(sweep("").exit_code, 0);
    rows = test::fileText(table);
    fan = test::fileText(out + "/fan.csv");
  }

  test::Outcome sweep(const std::string& options) const {
    return test::sweep(command() + " " + options, kWithoutPlot);
  }

  std::string rows, fan;
};

/// Another row in place of that of run 3, and what is said of it behind the path of the table.
struct RowEdit {
  std::string row, message;
  bool is_word = false;   ///< the varied value is a word, which the form of a row may allow
  bool has_form = false;  ///< it is a row that a sweep might have written
};

std::vector<RowEdit> editsOf(const std::string& row) {
  const std::size_t value = row.find(',') + 1, result = row.find(',', value) + 1;
  const auto edited = [&row](std::size_t at, const std::string& text) {
    return row.substr(0, at) + text + row.substr(row.find_first_of(',', at));
  };
  const auto fields = std::count(row.begin(), row.end(), ',') + 1;
  const std::string anew = "'; somebody has changed the table: remove it, and make its runs anew\n";
  const std::string until_status = row.substr(0, row.rfind(',') + 1);
  return {
      {edited(value, "abc"), ":5: field 2 must be a number, got 'abc" + anew, true},
      {edited(result, ""), ":5: field 3 must be a number, got '" + anew},
      {until_status + "refused: me", ":5: field 3 must be empty, as the run has no result, got '" +
                                         row.substr(result, row.find(',', result) - result) + anew},
      {until_status + "ok",
       ":5: status must be done, refused: or diverged: with why, got 'ok" + anew},
      {row + ",1", ":5: must have " + std::to_string(fields) + " fields, got '" +
                       std::to_string(fields + 1) + anew},
      {edited(value, "1.5"),
       ": its rows are not those that were written; somebody has changed the "
       "table: remove it, and make its runs anew\n",
       false, true}};
}

/// Of a table that has lost its last row, and another of whose rows is not as it was.
void expectDifferentRowsToBeNoticed(const test::Outcome& resumed, const std::string& table) {
  EXPECT_EQ(resumed.exit_code, 0);
  EXPECT_EQ(resumed.out.find("sweep: notice: " + table +
                             ": has lost its last rows, of 9; of the 8 that are left only the form "
                             "could be checked\n"),
            0U)
      << resumed.out;
  EXPECT_NE(resumed.out.find("with the runs that were lost its rows are not those that were "
                             "written: somebody has changed it, or "),
            std::string::npos)
      << resumed.out;
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
  const FinishedSweep bench;
  const std::string& rows = bench.rows;
  const std::size_t row = rows.find("\n3,") + 1, end = rows.find('\n', row);
  for (const RowEdit& edit : editsOf(rows.substr(row, end - row))) {
    const std::string text = rows.substr(0, row) + edit.row + rows.substr(end);
    const std::string message = "sweep: " + bench.table + edit.message;
    bench.files.written("out/runs.csv", text);
    const test::Outcome resumed = bench.sweep("--resume");
    EXPECT_EQ(resumed.exit_code, 1);
    EXPECT_EQ(resumed.out, message);
    EXPECT_EQ(test::fileText(bench.table), text);
    if (edit.is_word) continue;  // as a table may hold it, for all that merge knows
    EXPECT_EQ(test::sweep("merge " + bench.out, kWithoutPlot).out, message);
    EXPECT_FALSE(std::ifstream(bench.table + ".part").good());
    // of a table that has lost its end the form can be checked
    bench.files.written("out/runs.csv", text.substr(0, text.rfind("\n8,") + 1));
    const test::Outcome cut = bench.sweep("--resume");
    if (edit.has_form)
      expectDifferentRowsToBeNoticed(cut, bench.table);
    else
      EXPECT_EQ(cut.out, message);
  }
}

TEST(SweepProgram, SaysNothingMoreOfLostRowsThatAreMadeAgainAlike) {
  const FinishedSweep bench;
  bench.files.written("out/runs.csv", bench.rows.substr(0, bench.rows.find("\n7,") + 1));
  const std::string made_whole = bench.sweep("--resume").out;
  EXPECT_EQ(made_whole.find("notice"), made_whole.rfind("notice")) << made_whole;
  EXPECT_EQ(test::fileText(bench.table), bench.rows);
}

TEST(SweepProgram, ChecksEveryRowOfAFanBeforeARun) {
  const FinishedSweep bench;
  const std::string& fan = bench.fan;
  // a result that another has
  const std::size_t at = fan.find("\n3,") + 3;
  const std::string changed = fan.substr(0, at) + "7" + fan.substr(fan.find(',', at));
  bench.files.written("out/fan.csv", changed);
  const std::string message = "sweep: " + bench.out +
                              "/fan.csv: its rows are not those that were written; somebody has "
                              "changed the table: remove it, and --resume makes it again\n";
  EXPECT_EQ(bench.sweep("--resume").out, message);
  EXPECT_EQ(test::sweep("merge " + bench.out, kWithoutPlot).out, message);
  EXPECT_EQ(test::fileText(bench.out + "/fan.csv"), changed);
  // its rows alone are made again
  ASSERT_EQ(remove((bench.out + "/fan.csv").c_str()), 0);
  const test::Outcome made = bench.sweep("--resume");
  EXPECT_EQ(made.out.find("sweep: notice: " + bench.out +
                          "/fan.csv: has lost rows, which are made again"),
            0U)
      << made.out;
  EXPECT_EQ(test::fileText(bench.out + "/fan.csv"), fan);
  EXPECT_EQ(test::fileText(bench.table), bench.rows);
  EXPECT_EQ(bench.sweep("--resume").out.find("notice"), std::string::npos);
}

}  // namespace rigid_body_sim
