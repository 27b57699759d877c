#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/sweep/shard.hpp"

namespace rigid_body_sim {

/// What the command line of `sweep` says; absent means as the study says.
struct SweepOptions {
  std::string scene, study;
  std::vector<std::string> merge;  ///< directories of shards; empty: no merge
  std::optional<std::int64_t> runs;
  std::optional<std::uint64_t> seed;
  std::optional<std::int64_t> run;  ///< whose scene is written
  int threads = 1;
  LaunchedShard launched;
  std::optional<std::string> out;  ///< directory
  bool resume = false;
  bool help = false;

  /// Where the results go.
  std::string directory() const { return out.value_or(merge.empty() ? "." : merge.front()); }
};

/// Throws UsageError.
SweepOptions parseSweepOptions(int argc, char** argv, const Environment& environment);

/// The text of --help.
std::string sweepHelp();

}  // namespace rigid_body_sim
