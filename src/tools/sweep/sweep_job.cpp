#include "tools/sweep/sweep_job.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "math/shortest.hpp"
#include "programs/make_directory.hpp"
#include "programs/package_directory.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "scene/files/number_text.hpp"
#include "scene/files/read_file.hpp"
#include "scene/limits.hpp"
#include "scene/message_text.hpp"
#include "scene/readers/file_type.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/sweep/run_table.hpp"
#include "tools/sweep/scene_files.hpp"
#include "tools/sweep/stop_signals.hpp"

namespace rigid_body_sim {
namespace {

std::string joined(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : ",") + field;
  return line;
}

std::string fanHeader(const std::vector<double>& instants) {
  std::string header = "run";
  for (const double t : instants) header += "," + numberText(t);
  return header;
}

SweepInputs inputsOf(const SweepOptions& options) {
  SweepInputs inputs;
  inputs.study = loadStudy(options.study, options.runs, options.seed);
  requireSceneName(options.scene);
  inputs.scene_text = readFile(options.scene, "scene file", kMaxSceneBytes);
  inputs.context.source = options.scene;
  inputs.context.directory = std::filesystem::path(options.scene).parent_path();
  inputs.context.find_package = packageDirectory;
  return inputs;
}

std::string baseName(const std::string& path) {
  return oneLine(std::filesystem::path(path).filename().string());
}

}  // namespace

SweepJob::SweepJob(const SweepOptions& options)
    : options_(options), shard_(options.launched.shard), inputs_(inputsOf(options)) {
  runners_.push_back(std::make_unique<SweepRunner>(inputs_));
  SweepRunner& runner = *runners_.front();
  runner.checkPaths();
  info_.title = baseName(options.scene) + ", " + baseName(options.study);
  info_.digest = digestOfAll();
  info_.runs = runner.runs();
  info_.varied = runner.variedColumns();
  info_.records = runner.records().size();
  info_.fan = runner.fanName();
}

/// Of scene, study and seed, and of the files that were read for the scene and for every value that
/// a study lists.
std::uint64_t SweepJob::digestOfAll() const {
  std::vector<std::string> texts = {inputs_.scene_text,
                                    readFile(options_.study, "study file", kMaxSceneBytes),
                                    std::to_string(inputs_.study.seed)};
  for (std::string& file : digestsOfFiles(runners_.front()->context()))
    texts.push_back(std::move(file));
  return digestOf(texts);
}

std::string SweepJob::path(const std::string& stem, const std::string& extension) const {
  return (std::filesystem::path(options_.directory()) / shard_.fileName(stem, extension)).string();
}

std::string SweepJob::sceneName(std::int64_t number) {
  return "run_" + std::to_string(number) + ".yaml";
}

std::string SweepJob::writeScene(std::int64_t number) {
  if (number >= info_.runs)
    throw UsageError("--run: must be less than the " + std::to_string(info_.runs) +
                     " runs of the study, got " + std::to_string(number));
  const std::string scene = runners_.front()->sceneOf(number);
  makeDirectory(options_.directory());
  std::string path = (std::filesystem::path(options_.directory()) / sceneName(number)).string();
  std::string heading = "# run " + std::to_string(number) + " of " + info_.title + ", seed " +
                        std::to_string(inputs_.study.seed);
  if (inputs_.study.duration)
    heading += "; its row is after simulate --duration " + shortest(*inputs_.study.duration);
  writeText(path, heading + "\n" + scene);
  return path;
}

/// Rows that an interrupted sweep has finished, in both tables.
std::int64_t SweepJob::rowsToKeep() const {
  const std::optional<std::string> info = textOf(path("runs", ".info"));
  const std::string table = path("runs", ".csv");
  const std::int64_t there = wholeRows(table);
  if (there == 0) return 0;
  if (!info)
    throw std::runtime_error(table + ": of which sweep it is would stand in " +
                             path("runs", ".info") +
                             ", which is not there; remove the table, or leave --resume out");
  if (info != toText(info_))
    throw std::runtime_error(table +
                             ": is of another sweep: the scene, the study, the seed, or a file "
                             "that the scene names is another; remove it, or leave --resume out");
  const std::int64_t rows = std::min(there, shard_.runsOf(info_.runs));
  if (info_.fan.empty()) return rows;
  const std::int64_t fan = wholeRows(path("fan", ".csv"));
  return fan < std::min(rows, shard_.runsOf(info_.fanRuns())) ? fan : rows;
}

/// What meshes the first has read the others need not read again.
void SweepJob::addRunners(std::int64_t runs) {
  const auto threads = std::min<std::int64_t>(options_.threads, std::max<std::int64_t>(1, runs));
  inputs_.context = runners_.front()->context();
  while (static_cast<std::int64_t>(runners_.size()) < threads)
    runners_.push_back(std::make_unique<SweepRunner>(inputs_));
}

struct SweepJob::Tables {
  RunTable runs;
  std::optional<RunTable> fan;
};

/// Opens them after the rows that are kept; none: anew.
SweepJob::Tables SweepJob::openTables(std::int64_t kept) const {
  const auto open = [&](const std::string& stem, const std::string& header, std::int64_t rows) {
    const std::string file = path(stem, ".csv");
    return kept > 0 ? RunTable::reopen(file, header, rows, shard_) : RunTable::create(file, header);
  };
  const SweepRunner& runner = *runners_.front();
  Tables tables{open("runs", joined(runner.columns()), kept), std::nullopt};
  // before any row: rows without a description cannot be gone on with
  if (kept == 0) writeText(path("runs", ".info"), toText(info_));
  if (!info_.fan.empty())
    tables.fan.emplace(open("fan", fanHeader(runner.fanInstants()),
                            std::min(kept, shard_.runsOf(info_.fanRuns()))));
  return tables;
}

void SweepJob::run() {
  makeDirectory(options_.directory());
  const std::int64_t all = shard_.runsOf(info_.runs);
  const std::int64_t kept = options_.resume ? rowsToKeep() : 0;
  Tables tables = openTables(kept);
  addRunners(all - kept);

  const StopSignals signals;
  ProgressBar bar;
  SweepPool pool(
      runners_, shard_,
      [&](const std::string& rows, const std::string& fan_lines) {
        tables.runs.append(rows);
        if (tables.fan) tables.fan->append(fan_lines);
      },
      signals.requested());
  const SweepOutcome outcome = pool.run(kept, all, [&](std::int64_t written) {
    bar.show(static_cast<double>(written) /
             static_cast<double>(std::max<std::int64_t>(1, all - kept)));
  });
  report(outcome, kept);
  if (kept + outcome.written < all) signals.endIfRequested();
}

/// What the user must know of runs without results, of those that are not sure ones, and of those
/// that were not begun.
void SweepJob::report(const SweepOutcome& outcome, std::int64_t kept) const {
  const auto notify = [](std::int64_t runs, const std::string& what, const std::string& first) {
    if (runs > 0)
      std::fprintf(
          stderr, "%s\n",
          noticeLine("sweep", std::to_string(runs) + what + "; the first is " + first).c_str());
  };
  notify(outcome.refused, " runs have no result", outcome.first_refusal);
  notify(outcome.doubtful, " runs may be wrong by more than they should", outcome.first_doubt);
  const std::int64_t all = shard_.runsOf(info_.runs);
  const std::int64_t done = kept + outcome.written;
  if (done == all) return;
  std::fprintf(stderr,
               "sweep: stopped after %lld of %lld runs; the same command with --resume goes on\n",
               static_cast<long long>(done), static_cast<long long>(all));
}

}  // namespace rigid_body_sim
