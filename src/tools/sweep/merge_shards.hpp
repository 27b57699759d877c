#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "tools/sweep/sweep_info.hpp"

namespace rigid_body_sim {

/// Makes one table of those of all shards in the directories, row by row in the order of the runs,
/// as runs.csv (and fan.csv, runs.info) in another. Throws std::runtime_error, one line, and leaves
/// what was there, where a shard is missing, not finished, twice there, or of another sweep.
/// Nothing where it is told to stop, and then leaves what was there, too.
std::optional<TableInfo> mergeShards(const std::vector<std::string>& directories,
                                     const std::string& out, const std::atomic<bool>& stop);

}  // namespace rigid_body_sim
