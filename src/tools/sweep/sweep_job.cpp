#include "tools/sweep/sweep_job.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "math/shortest.hpp"
#include "programs/make_directory.hpp"
#include "programs/package_directory.hpp"
#include "programs/step_watch.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "scene/files/number_text.hpp"
#include "scene/files/read_file.hpp"
#include "scene/limits.hpp"
#include "scene/message_text.hpp"
#include "scene/readers/file_type.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/sweep/other_tables.hpp"
#include "tools/sweep/scene_files.hpp"

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
  // once: what comes through a pipe cannot be read again, and a file may be another by then
  inputs.study_text = readFile(options.study, "study file", kMaxSceneBytes);
  inputs.study = parseStudy(inputs.study_text, options.study, options.runs, options.seed);
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
    : options_(options),
      shard_(options.launched.shard),
      files_{shard_, options.directory()},
      inputs_(inputsOf(options)) {
  runners_.push_back(std::make_unique<SweepRunner>(inputs_));
  const SweepRunner& runner = *runners_.front();
  checkPaths();
  SweepInfo& sweep = info_.sweep;
  sweep.title = baseName(options.scene) + ", " + baseName(options.study);
  sweep.digest = digestOfAll();
  sweep.runs = runner.runs();
  sweep.varied = runner.rowForm().varied;
  sweep.records = runner.records().size();
  sweep.fan = runner.fanName();
}

/// Which may go through whole runs.
void SweepJob::checkPaths() {
  StepWatch watch(notify, 10, [](double) {
    return std::string(
        "led to the first run: every path and every value of a list is tried, some by whole runs, "
        "and these are long or many");
  });
  watch.begin(StepWatch::kBeforeTheRun);
  runners_.front()->checkPaths();
}

/// Of scene, study and seed, and of the files that were read for the scene and for every value that
/// a study lists.
std::uint64_t SweepJob::digestOfAll() const {
  std::vector<std::string> texts = {inputs_.scene_text, inputs_.study_text,
                                    std::to_string(inputs_.study.seed)};
  for (std::string& file : digestsOfFiles(runners_.front()->context()))
    texts.push_back(std::move(file));
  return digestOf(texts);
}

std::vector<std::string> SweepJob::filesOfScene() const {
  const std::set<std::string>& files = runners_.front()->context().files;
  return {files.begin(), files.end()};
}

std::string SweepJob::sceneName(std::int64_t number) {
  return "run_" + std::to_string(number) + ".yaml";
}

std::string SweepJob::writeScene(std::int64_t number) {
  if (number >= info_.sweep.runs)
    throw UsageError("--run: must be less than the " + std::to_string(info_.sweep.runs) +
                     " runs of the study, got " + std::to_string(number));
  const std::string scene = runners_.front()->sceneOf(number);
  makeDirectory(options_.directory());
  const std::string path =
      (std::filesystem::path(options_.directory()) / sceneName(number)).string();
  requireSceneOfASweep(path);
  std::string heading = "# run " + std::to_string(number) + " of ";
  // whose values depend on it
  if (inputs_.study.latin_hypercube) heading += std::to_string(info_.sweep.runs) + " runs of ";
  heading += info_.sweep.title + ", seed " + std::to_string(inputs_.study.seed);
  if (inputs_.study.duration)
    heading += "; its row is after simulate --duration " + shortest(*inputs_.study.duration);
  writeText(path, heading + "\n" + scene);
  return path;
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

  void requireInPlace() const {
    runs.requireInPlace();
    if (fan) fan->requireInPlace();
  }
};

void SweepJob::notify(const std::string& notice) {
  if (!notice.empty()) std::fprintf(stderr, "%s\n", noticeLine("sweep", notice).c_str());
}

TableHeaders SweepJob::headers() const {
  const SweepRunner& runner = *runners_.front();
  return {joined(runner.columns()), fanHeader(runner.fanInstants()), runner.rowForm()};
}

/// What is gone on with; nothing where the tables begin anew.
KeptRows SweepJob::rowsToKeep() const {
  KeptRows kept;
  if (options_.resume)
    kept = keptRows(files_, info_.sweep, headers());
  else
    notify(refuseToReplace(files_, info_.sweep));
  for (const std::string& notice : kept.notices) notify(notice);
  return kept;
}

SweepJob::Tables SweepJob::openTables(LockedFile runs, const KeptRows& kept) {
  const auto open = [](LockedFile file, const std::string& header, std::int64_t bytes) {
    return bytes > 0 ? RunTable::reopen(std::move(file), bytes)
                     : RunTable::create(std::move(file), header);
  };
  const TableHeaders first = headers();
  info_.ledger = kept.ledger;
  info_.lost = kept.lost;
  // before any row: rows without a description cannot be gone on with
  writeInfo();
  if (kept.bytes == 0) removeOldResults(files_, !info_.sweep.fan.empty());
  Tables tables{open(std::move(runs), first.runs, kept.bytes), std::nullopt};
  if (!info_.sweep.fan.empty())
    tables.fan.emplace(open(LockedFile(files_.path("fan", ".csv")), first.fan, kept.fan_bytes));
  return tables;
}

void SweepJob::writeInfo() {
  writeText(files_.path("runs", ".info"), toText(info_));
  info_written_ = std::chrono::steady_clock::now();
  info_is_due_ = false;
}

/// Not with each of many short writes: where files are far away it takes as long as many runs.
void SweepJob::writeInfoSometimes(const Tables& tables) {
  constexpr auto kPause = std::chrono::milliseconds(100);
  if (!info_is_due_ || std::chrono::steady_clock::now() - info_written_ < kPause) return;
  tables.requireInPlace();
  writeInfo();
}

void SweepJob::run(std::optional<StopSignals>& signals) {
  try {
    makeTables(signals);
  } catch (const WriteError& error) {
    if (info_.ledger.rows == 0) throw;
    throw std::runtime_error(std::string(error.what()) +
                             "; rows that are written are kept: once it can be written, the same "
                             "command with --resume goes on");
  }
}

void SweepJob::makeTables(std::optional<StopSignals>& kept_signals) {
  makeDirectory(options_.directory());
  refuseOtherDivisions(options_.directory(), shard_);
  requireFilesOfASweep(files_, !info_.sweep.fan.empty());
  LockedFile runs(files_.path("runs", ".csv"));
  const KeptRows kept = rowsToKeep();
  const StopSignals& signals = kept_signals.emplace();
  Tables tables = openTables(std::move(runs), kept);
  const std::int64_t all = shard_.runsOf(info_.sweep.runs), first = kept.ledger.rows;
  const bool needs_fan = tables.fan && kept.fan_bytes == 0 && kept.fan_rows > 0;
  addRunners(std::max(all - first, needs_fan ? kept.fan_rows : 0));
  if (needs_fan) makeFanAgain(*tables.fan, kept.fan_rows, signals);
  std::int64_t written = 0;
  if (kept.lost.rows > 0) {
    written = makeRuns(tables, first, kept.lost.rows, signals);
    if (first + written == kept.lost.rows) endLoss();
  }
  if (!signals.requested()) written += makeRuns(tables, first + written, all, signals);
  if (first + written == all) return;
  std::fprintf(stderr, "sweep: stopped after %lld of %lld runs; the same command %s\n",
               static_cast<long long>(first + written), static_cast<long long>(all),
               first + written > 0 ? "with --resume goes on" : "begins anew");
  signals.endIfRequested();
}

/// The rows that were lost are there again.
void SweepJob::endLoss() {
  NotedRuns& doubtful = info_.ledger.doubtful;
  if (info_.ledger.digest != info_.lost.digest) {
    info_.ledger.is_other = true;
    notify(noticeOfOtherRows(files_));
  } else if (!info_.lost.is_at_least) {
    doubtful.count = info_.lost.doubtful;
    doubtful.is_at_least = false;
  }
  info_.lost = {};
  writeInfo();
}

/// Of runs whose rows are there. The digest stays unknown until it is that of all of them.
void SweepJob::makeFanAgain(RunTable& fan, std::int64_t rows, const StopSignals& signals) {
  std::uint64_t digest = 0;
  SweepPool pool(
      runners_, shard_,
      [&](const MadeRuns& made) {
        fan.append(made.fan);
        digest += made.ledger.fan_digest;
      },
      signals.requested());
  if (pool.run(0, rows, [](std::int64_t) {}) < rows) return;
  info_.ledger.fan_digest = digest;
  writeInfo();
}

/// Returns how many are written.
std::int64_t SweepJob::makeRuns(Tables& tables, std::int64_t first, std::int64_t all,
                                const StopSignals& signals) {
  ProgressBar bar;
  SweepPool pool(
      runners_, shard_,
      [&](const MadeRuns& made) {
        tables.runs.append(made.rows);
        if (tables.fan) tables.fan->append(made.fan);
        info_.ledger.add(made.ledger);
        info_is_due_ = true;
      },
      signals.requested());
  bool has_said = false;
  const auto goOn = [&](std::int64_t written) {
    if (signals.requested() && !std::exchange(has_said, true))
      std::fprintf(stderr, "%s\n",
                   "sweep: stopping when the runs under way have ended; once more, and it ends at "
                   "once without them");
    writeInfoSometimes(tables);
    bar.show(static_cast<double>(written) /
             static_cast<double>(std::max<std::int64_t>(1, all - first)));
  };
  try {
    const std::int64_t written = pool.run(first, all, goOn);
    tables.requireInPlace();
    writeInfo();
    return written;
  } catch (...) {
    keepInfo();
    throw;
  }
}

/// Where something has failed already, of which the user is told: on a full disk it takes the room
/// of the one before.
void SweepJob::keepInfo() const { overwriteText(files_.path("runs", ".info"), toText(info_)); }

}  // namespace rigid_body_sim
