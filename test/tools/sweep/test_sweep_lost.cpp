#include <algorithm>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/sweep/kept_rows.hpp"
#include "tools/sweep/sweep_bench.hpp"
#include "tools/sweep/sweep_info.hpp"

/// Tables that have lost rows, and descriptions that are not as they were written.
namespace rigid_body_sim {
namespace {

const std::string kOtherRows = "with the runs that were lost its rows are not those";

/// A sweep that has been made, whose files can be changed. Without a fan.
struct LostRowsBench : test::SweepFiles {
  LostRowsBench(const std::string& scene_text, const std::string& study_text)
      : SweepFiles(scene_text, study_text) {
    EXPECT_EQ(sweep().exit_code, 0);
    rows = test::fileText(table);
    info = infoText();
  }

  test::Outcome sweep(const std::string& options = "", int most_kilobytes = 0) const {
    const std::string limit =
        most_kilobytes > 0 ? "ulimit -f " + std::to_string(most_kilobytes) + ";" : "";
    return sweepAfter(limit, options);
  }
  std::string infoText() const { return test::fileText(out + "/runs.info"); }
  TableInfo infoThere() const { return tableInfoIn(infoText()).value_or(TableInfo{}); }

  /// The rows before that of a run.
  std::string rowsBefore(int run) const {
    return rows.substr(0, rows.find("\n" + std::to_string(run) + ",") + 1);
  }
  /// With another value in the row of run 3.
  static std::string edited(std::string text) {
    const std::size_t value = text.find("\n3,") + 3;
    return text.replace(value, text.find(',', value) - value, "1.5");
  }
  void write(const std::string& text) const { files.written("out/runs.csv", text); }

  std::string rows, info;  // as they were written
};

const std::string kManyRuns = "runs: 400\nvary: {horizon: {uniform: [1, 2]}}";

}  // namespace

// Until the place is passed again, however often that is interrupted, and whatever is lost again.
TEST(SweepProgram, KeepsTheDigestOfRowsThatWereLost) {
  const LostRowsBench bench(test::kPushedBall, kManyRuns);
  const int room = static_cast<int>(bench.rowsBefore(200).size() / 1024);
  for (const bool is_edited : {true, false}) {
    bench.write(is_edited ? LostRowsBench::edited(bench.rowsBefore(100)) : bench.rowsBefore(100));
    bench.files.written("out/runs.info", bench.info);
    for (int i = 0; i < 2; ++i) {
      const test::Outcome stopped = bench.sweep("--resume", room);
      EXPECT_EQ(stopped.exit_code, 1);
      EXPECT_NE(stopped.out.find("File too large"), std::string::npos) << stopped.out;
      EXPECT_EQ(stopped.out.find(kOtherRows), std::string::npos) << stopped.out;
      const TableInfo there = bench.infoThere();
      EXPECT_GE(there.ledger.rows, 100);
      EXPECT_LT(there.ledger.rows, 250);
      EXPECT_EQ(there.lost.rows, 400);
      EXPECT_EQ(there.lost.digest, tableInfoIn(bench.info)->ledger.digest);
      const std::string text = test::fileText(bench.table);
      bench.write(text.substr(0, text.find("\n80,") + 1));
    }
    const test::Outcome whole = bench.sweep("--resume");
    EXPECT_EQ(whole.exit_code, 0) << whole.out;
    EXPECT_EQ(whole.out.find(kOtherRows) != std::string::npos, is_edited) << whole.out;
    EXPECT_EQ(bench.infoThere().lost.rows, 0);
    EXPECT_EQ(bench.infoText() == bench.info, !is_edited);
    // and does not forget it
    for (const std::string& later :
         {bench.sweep("--resume").out, test::sweep("merge " + bench.out).out,
          bench.sweep("--resume").out})
      EXPECT_EQ(later.find("sweep: notice: " + bench.table + ": " + kOtherRows) == 0, is_edited)
          << later;
  }
}

// It is looked at by the next one, and merge is none.
TEST(SweepProgram, LooksAtLostRowsThatWereMadeBeforeItWasEnded) {
  const LostRowsBench bench(test::kPushedBall, kManyRuns);
  TableInfo info = bench.infoThere();
  info.lost = {400, info.ledger.digest + 1, 0, false};
  bench.files.written("out/runs.info", toText(info));
  EXPECT_EQ(test::sweep("merge " + bench.out).out,
            "sweep: " + bench.table +
                ": had lost rows, and was ended before those that were made again were checked; "
                "finish it with --resume\n");
  EXPECT_NE(bench.sweep("--resume").out.find(kOtherRows), std::string::npos);
  TableInfo other = tableInfoIn(bench.info).value();
  other.ledger.is_other = true;
  EXPECT_EQ(bench.infoText(), toText(other));
  EXPECT_EQ(test::sweep("merge " + bench.out).exit_code, 0);
}

TEST(SweepLedger, KnowsOfItsPartsThatTheyAreOther) {
  SweepLedger whole, other;
  whole.add(SweepLedger{});
  EXPECT_FALSE(whole.is_other);
  other.is_other = true;
  whole.add(other);
  whole.add(SweepLedger{});
  EXPECT_TRUE(whole.is_other);
}

TEST(SweepProgram, SaysThatAllRowsAreLost) {
  const LostRowsBench bench(test::kPushedBall, kManyRuns);
  for (const std::string& left : {std::string(), bench.rowsBefore(0)}) {
    bench.write(left);
    const test::Outcome again = bench.sweep("--resume");
    EXPECT_EQ(again.out.find("sweep: notice: " + bench.table +
                             ": has lost all its rows, of 400, which are made again\n"),
              0U)
        << again.out;
    EXPECT_EQ(test::fileText(bench.table), bench.rows);
    EXPECT_EQ(bench.infoText(), bench.info);
  }
}

TEST(KeptRows, AreThoseOfTheirDigestAlone) {
  const TemporaryDirectory files;
  const ShardFiles nothing{Shard{}, files.path("")};
  SweepLedger ledger;
  ledger.digest = ledger.fan_digest = 5;
  for (const std::uint64_t digest : {4, 5, 6}) {
    const auto isTaken = [&](auto require) {
      try {
        require();
        return true;
      } catch (const std::runtime_error&) {
        return false;
      }
    };
    EXPECT_EQ(isTaken([&] { requireLedger(nothing, ledger, digest, {}); }), digest == 5);
    EXPECT_EQ(isTaken([&] { requireFan("fan.csv", ledger, digest); }), digest == 5);
  }
}

TEST(SweepLedger, KnowsHowManyAreDoubtfulAsFarAsTheyAreNamed) {
  SweepLedger all;
  for (std::int64_t run = 0; run < 1500; ++run) all.addDoubt(2 * run, "why");
  const auto before = [&](std::int64_t end) {
    SweepLedger first;
    first.addDoubtsBefore(end, all);
    return first;
  };
  EXPECT_EQ(before(1000).doubtful.count, 500);
  EXPECT_FALSE(before(1000).doubtful.is_at_least);
  EXPECT_EQ(before(1998).doubtful.count, 999);
  EXPECT_FALSE(before(1998).doubtful.is_at_least);
  EXPECT_EQ(before(2500).doubtful.count, 1000);
  EXPECT_TRUE(before(2500).doubtful.is_at_least);
  EXPECT_EQ(before(2500).doubtful_runs.size(), 1000U);
  // what is known of a part only is not known of the whole
  SweepLedger whole = before(1000);
  whole.add(before(2500));
  EXPECT_TRUE(whole.doubtful.is_at_least);
  SweepLedger few;
  few.addDoubt(3, "why");
  SweepLedger first;
  first.addDoubtsBefore(100, few);
  EXPECT_EQ(first.doubtful.count, 1);
  EXPECT_EQ(first.doubtful.why, "why");
  EXPECT_FALSE(first.doubtful.is_at_least);
}

TEST(SweepProgram, CountsDoubtfulRunsWhereRowsWereLost) {
  // of one step each, so that nothing tells their errors
  const LostRowsBench bench(
      R"(time_step: 0.01
integrator: rk4
bodies: [{name: ball, shape: {sphere: {radius: 0.1}}, mass: 1, position: [1, 0, 0]}]
forces: [{type: spring, from: {body: ball}, to: {world: [0, 0, 0]}, stiffness: 10}]
)",
      "runs: 1100\nduration: 0.01\nvary: {'forces[0].stiffness': {uniform: [1, 2]}}");
  EXPECT_EQ(bench.infoThere().ledger.doubtful.count, 1100);
  bench.write(bench.rowsBefore(1060));
  const test::Outcome again = bench.sweep("--resume");
  EXPECT_NE(again.out.find("notice: 1100 runs may have errors"), std::string::npos) << again.out;
  EXPECT_EQ(bench.infoText(), bench.info);
  bench.write(LostRowsBench::edited(bench.rowsBefore(1060)));
  const test::Outcome other = bench.sweep("--resume");
  // 1000 that are named, and 40 that were made again
  EXPECT_NE(other.out.find("notice: at least 1040 runs may have errors"), std::string::npos)
      << other.out;
  EXPECT_NE(bench.sweep("--resume").out.find("notice: at least 1040 runs"), std::string::npos);
}

TEST(SweepProgram, BelievesNoDescriptionThatWasChanged) {
  LostRowsBench bench(test::kDoubtfulBall,
                      "runs: 6\nvary: {bodies.ball.mass: {uniform: [-0.5, 1]}}");
  const std::string path = bench.out + "/runs.info";
  const auto fault = [&](const std::string& text) {
    bench.files.written("out/runs.info", text);
    const std::string resumed = bench.sweep("--resume").out,
                      merged = test::sweep("merge " + bench.out).out;
    const std::string head = "sweep: " + path + ": ",
                      tail =
                          "; only by it is known of which sweep the rows of runs.csv are: put "
                          "it back, or remove runs.csv to begin anew\n";
    // they may be of this one
    EXPECT_EQ(bench.sweep().out, resumed);
    EXPECT_EQ(test::fileText(bench.table), bench.rows);
    EXPECT_EQ(resumed.substr(0, head.size()), head);
    EXPECT_EQ(resumed.substr(std::max(tail.size(), resumed.size()) - tail.size()), tail);
    const std::string why = resumed.substr(
        head.size(), resumed.size() - std::min(resumed.size(), head.size() + tail.size()));
    EXPECT_EQ(merged, "sweep: " + path + ": " + why + "\n");
    return why;
  };
  const auto with = [&](const std::string& line, const std::string& other) {
    const std::size_t begin = bench.info.find("\n" + line) + 1, end = bench.info.find('\n', begin);
    return bench.info.substr(0, begin) + other + bench.info.substr(end + (other.empty() ? 1 : 0));
  };
  const std::string changed = "is not as it was written: somebody has changed it, or it was cut";
  for (const auto& [line, other] :
       {std::pair<std::string, std::string>{"no_result", "no_result 0 0 "},
        {"doubtful ", "doubtful 1 0 why"},
        {"doubtful_runs", "doubtful_runs 1 "},
        {"title", "title mine"},
        {"rows ", ""},
        {"rows ", "rows 006"},
        {"seal", ""},
        {"seal", "seal 1"},
        {"seal", bench.info.substr(bench.info.find("seal ")) + "x"}})
    EXPECT_EQ(fault(with(line, other)), changed) << line << other;
  EXPECT_EQ(fault("rigid_body_sim sweep 1" + bench.info.substr(bench.info.find('\n'))),
            "is of another version of this program, 'rigid_body_sim sweep 1', not 'rigid_body_sim "
            "sweep 3'");
  bench.write(bench.rowsBefore(4));
  bench.rows = bench.rowsBefore(4);
  EXPECT_EQ(fault(""), "is empty");
  EXPECT_EQ(fault(bench.info.substr(0, 30)), changed);
  ASSERT_EQ(std::remove(path.c_str()), 0);
  EXPECT_EQ(bench.sweep().out.find("sweep: " + path + ": is not there; only by it is known"), 0U);
  bench.files.written("out/runs.info", bench.info);
  EXPECT_EQ(bench.sweep("--resume").exit_code, 0);
}

TEST(SweepInfo, TakesNoNumbersOfWhichSumsAreNone) {
  TableInfo info;
  info.sweep.runs = 100;
  info.ledger.rows = 40;
  EXPECT_TRUE(tableInfoIn(toText(info)));
  const auto isTaken = [&](auto change) {
    TableInfo other = info;
    change(other);
    return tableInfoIn(toText(other)).has_value();
  };
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.sweep.runs = 100000001; }));
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.sweep.varied = 1001; }));
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.sweep.records = 1001; }));
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.ledger.rows = 101; }));
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.ledger.rows = -1; }));
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.ledger.refused.count = 41; }));
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.ledger.doubtful.count = 41; }));
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.lost.rows = 39; }));
  EXPECT_FALSE(isTaken([](TableInfo& i) { i.lost = {50, 1, 51, false}; }));
  EXPECT_TRUE(isTaken([](TableInfo& i) { i.lost = {50, 1, 50, true}; }));
  EXPECT_TRUE(isTaken([](TableInfo& i) { i.ledger.doubtful_runs = {0, 7, 99}; }));
  for (const std::vector<std::int64_t>& named :
       {std::vector<std::int64_t>{7, 3}, {3, 3}, {-1}, {100}})
    EXPECT_FALSE(isTaken([&](TableInfo& i) { i.ledger.doubtful_runs = named; }));
}

}  // namespace rigid_body_sim
