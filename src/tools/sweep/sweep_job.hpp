#pragma once

#include <memory>
#include <vector>

#include "tools/sweep/locked_file.hpp"
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
  /// meanwhile, the table is left whole and the process ends by that signal.
  void run();

  const SweepInfo& info() const { return info_; }
  const std::vector<std::string>& notices() const { return runners_.front()->notices(); }

 private:
  struct Tables;

  std::string path(const std::string& stem, const std::string& extension) const;
  std::uint64_t digestOfAll() const;
  std::int64_t rowsToKeep() const;
  void refuseToReplace(std::int64_t rows) const;
  Tables openTables(LockedFile runs, std::int64_t kept) const;
  void addRunners(std::int64_t runs);
  void report(const SweepOutcome& outcome, std::int64_t kept) const;

  const SweepOptions& options_;
  Shard shard_;
  SweepInputs inputs_;
  std::vector<std::unique_ptr<SweepRunner>> runners_;
  SweepInfo info_;
};

}  // namespace rigid_body_sim
