// Runs a scene many times with varied values, on all cores or as one shard of several.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "programs/distinct_files.hpp"
#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "tools/common/gnuplot.hpp"
#include "tools/sweep/kept_rows.hpp"
#include "tools/sweep/merge_shards.hpp"
#include "tools/sweep/run_table.hpp"
#include "tools/sweep/stop_signals.hpp"
#include "tools/sweep/sweep_job.hpp"
#include "tools/sweep/sweep_plot.hpp"

namespace rigid_body_sim {
namespace {

/// What the user must know of runs without results, and of those that are not sure ones.
void notify(const SweepLedger& ledger) {
  const auto say = [](const NotedRuns& runs, const std::string& one, const std::string& more) {
    if (runs.count > 0)
      SweepJob::notify((runs.is_at_least ? "at least " : "") + std::to_string(runs.count) +
                       (runs.count == 1 ? one : more) + "; the first is run " +
                       std::to_string(runs.first) + ": " + runs.why);
  };
  say(ledger.refused, " run has no result", " runs have no result");
  say(ledger.doubtful, " run may have an error beyond the tolerance (runs.info says which)",
      " runs may have errors beyond the tolerance (runs.info says which)");
}

/// What is made of the whole table.
void report(const TableInfo& table, const std::string& directory) {
  const std::filesystem::path out = directory;
  const SweepInfo& info = table.sweep;
  const SweepSummary summary = summarise((out / "runs.csv").string(), info);
  // meanwhile somebody may have changed them
  requireLedger({Shard{}, out}, table.ledger, summary.digest,
                {summary.columns(), info.varied, info.records});
  const auto write = [&](const char* name, const std::string& text) {
    try {
      writeText((out / name).string(), text);
    } catch (const WriteError& error) {
      throw std::runtime_error(std::string(error.what()) +
                               "; all runs are in runs.csv: once it can be written, the same "
                               "command makes it, of a sweep with --resume");
    }
  };
  write("summary.csv", summaryCsv(summary));
  print(summaryTable(summary));
  if (hasGnuplot())
    write("sweep.svg", sweepPlot(summary, info, (out / "fan.csv").string()));
  else
    print(gnuplotIsMissing((out / "summary.csv").string() + " is there") + "\n");
}

std::vector<std::string> writtenFiles(const SweepOptions& options) {
  if (options.run) return {SweepJob::sceneName(*options.run)};
  const Shard& shard = options.launched.shard;
  std::vector<std::string> names = {shard.fileName("runs", ".csv"), shard.fileName("fan", ".csv"),
                                    shard.fileName("runs", ".info")};
  if (shard.count == 1) names.insert(names.end(), {"summary.csv", "sweep.svg"});
  return names;
}

/// files: what is read of the scene.
void requireDistinctFiles(const SweepOptions& options, std::vector<NamedFile> files) {
  const std::filesystem::path out = options.directory();
  files.push_back({"the study", options.study, false});
  for (const std::string& name : writtenFiles(options))
    files.push_back({name, (out / name).string(), true});
  requireDistinct(files);
}

/// Ends the process where it is asked to end.
TableInfo mergedTable(const SweepOptions& options, StopSignals& signals) {
  const auto info = mergeShards(options.merge, options.directory(), signals.requested());
  if (!info) {
    std::fprintf(stderr, "sweep: stopped: nothing is merged, and what was there is as it was\n");
    signals.endIfRequested();
  }
  signals.endAtOnce(
      "sweep: stopped: the shards are merged, and the same command makes summary and plot\n");
  return info.value();
}

void merge(const SweepOptions& options) {
  StopSignals signals;
  const TableInfo info = mergedTable(options, signals);
  notify(info.ledger);
  report(info, options.directory());
}

void run(const SweepOptions& options) {
  if (!options.merge.empty()) return merge(options);
  requireDistinctFiles(options, filesOfScene(options.scene, {}));
  SweepJob job(options);
  requireDistinctFiles(options, filesOfScene(options.scene, job.filesOfScene()));
  for (const std::string& notice : job.notices()) SweepJob::notify(notice);
  if (options.run) return print(job.writeScene(*options.run) + "\n");
  const Shard& shard = options.launched.shard;
  std::optional<StopSignals> signals;
  job.run(signals);
  if (shard.count == 1)
    signals->endAtOnce(
        "sweep: stopped: all runs are in runs.csv, and the same command with --resume makes "
        "summary and plot\n");
  notify(job.info().ledger);
  if (shard.count == 1) return report(job.info(), options.directory());
  print("shard " + std::to_string(shard.index) + " of " + std::to_string(shard.count) +
        (options.launched.by.empty() ? "" : " (" + options.launched.by + ")") +
        " is done; once all are: sweep merge " + options.directory() + "\n");
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  return runProgram("sweep", [&] {
    const SweepOptions options =
        parseSweepOptions(argc, argv, [](const char* name) { return std::getenv(name); });
    if (options.help)
      print(sweepHelp());
    else
      run(options);
  });
}
