#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "tools/sweep/kept_rows.hpp"
#include "tools/sweep/run_table.hpp"
#include "tools/sweep/stop_signals.hpp"
#include "tools/sweep/sweep_info.hpp"
#include "tools/sweep/sweep_options.hpp"
#include "tools/sweep/sweep_pool.hpp"
#include "tools/sweep/sweep_runner.hpp"

namespace rigid_body_sim {

/// Carries out a sweep from its files to its table. Throws SceneError, std::runtime_error.
class SweepJob {
 public:
  explicit SweepJob(const SweepOptions& options);

  /// The file of the scene of a run.
  static std::string sceneName(std::int64_t number);

  /// Writes it; returns its path. Throws UsageError for a run that there is none.
  std::string writeScene(std::int64_t number);

  /// Makes the runs of the shard that are not there yet. Where the process is asked to end
  /// meanwhile, the table is left whole and the process ends by that signal. signals: are made when
  /// there is something to leave whole.
  void run(std::optional<StopSignals>& signals);

  /// Of the table as it is.
  const TableInfo& info() const { return info_; }
  const std::vector<std::string>& notices() const { return runners_.front()->notices(); }

  /// That the scene names, with every value that the study lists.
  std::vector<std::string> filesOfScene() const;

  /// Writes a line for the user; none for an empty notice.
  static void notify(const std::string& notice);

 private:
  struct Tables;

  void checkPaths();
  void makeTables(std::optional<StopSignals>& kept_signals);
  std::uint64_t digestOfAll() const;
  TableHeaders headers() const;
  KeptRows rowsToKeep() const;
  Tables openTables(LockedFile runs, const KeptRows& kept);
  void addRunners(std::int64_t runs);
  void makeFanAgain(RunTable& fan, std::int64_t rows, const StopSignals& signals);
  std::int64_t makeRuns(Tables& tables, std::int64_t first, std::int64_t all,
                        const StopSignals& signals);
  void endLoss();
  void writeInfo();
  void writeInfoSometimes(const Tables& tables);
  void keepInfo() const;

  const SweepOptions& options_;
  Shard shard_;
  ShardFiles files_;
  SweepInputs inputs_;
  std::vector<std::unique_ptr<SweepRunner>> runners_;
  TableInfo info_;
  bool info_is_due_ = false;
  std::chrono::steady_clock::time_point info_written_;
};

}  // namespace rigid_body_sim
