#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace rigid_body_sim {

/// Which of the runs a process takes: every count-th, from the run index − 1 on.
struct Shard {
  std::int64_t index = 1;  ///< 1 … count
  std::int64_t count = 1;

  /// Its j-th run, and how many of so many there are.
  std::int64_t run(std::int64_t j) const { return index - 1 + j * count; }
  std::int64_t runsOf(std::int64_t all) const { return (all - index + count) / count; }

  /// runs.csv, or runs.2of4.csv
  std::string fileName(const std::string& stem, const std::string& extension) const;
};

/// Where the tables of a shard are.
struct ShardFiles {
  Shard shard;
  std::filesystem::path directory;

  std::string path(const std::string& stem, const std::string& extension) const {
    return (directory / shard.fileName(stem, extension)).string();
  }
};

/// The shard whose table has this name, such as runs.2of4.csv; none of any other file.
std::optional<Shard> shardOfTable(std::string_view name);

/// "2/4". Throws UsageError.
Shard parseShard(const std::string& text);

/// What set the shard, for the user to see.
struct LaunchedShard {
  Shard shard;
  std::string by;  ///< the variable that gave its number; empty: no launcher
};

/// The value of an environment variable; null where it is not set.
using Environment = std::function<const char*(const char* name)>;

/// The shard that the launcher of this process set: an array of Slurm jobs, Open MPI's mpirun, the
/// PMI of other launchers, srun, GNU parallel or PMIx with RIGID_BODY_SIM_SHARDS for the number of
/// shards, which holds for arrays, too, where it is set. Throws UsageError for variables that do
/// not fit together.
LaunchedShard launchedShard(const Environment& environment);

}  // namespace rigid_body_sim
