#pragma once

#include <string>
#include <vector>

#include "tools/sweep/sweep_info.hpp"

namespace rigid_body_sim {

/// Makes one table of those of all shards in the directories, row by row in the order of the runs,
/// as runs.csv (and fan.csv, runs.info) in another. Throws std::runtime_error, one line, and leaves
/// what was there, where a shard is missing, not finished, twice there, or of another sweep.
TableInfo mergeShards(const std::vector<std::string>& directories, const std::string& out);

}  // namespace rigid_body_sim
