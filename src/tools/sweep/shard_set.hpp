#pragma once

#include <string>
#include <vector>

#include "tools/sweep/shard.hpp"
#include "tools/sweep/sweep_info.hpp"

namespace rigid_body_sim {

/// A table of a shard, and what stands beside it.
struct ShardTable {
  ShardFiles files;
  TableInfo info;
};

/// All shards of a sweep, by their number, from the directories; of a sweep that was not divided
/// its only one. Throws std::runtime_error where a shard is missing, not finished, twice there, or
/// of another sweep.
std::vector<ShardTable> shardsIn(const std::vector<std::string>& directories);

}  // namespace rigid_body_sim
