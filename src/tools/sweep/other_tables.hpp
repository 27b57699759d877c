#pragma once

#include <string>

#include "tools/sweep/shard.hpp"

namespace rigid_body_sim {

/// Throws std::runtime_error where a directory holds tables of another number of shards than this
/// one is of: runs would be made twice, and the tables could not be merged.
void refuseOtherDivisions(const std::string& directory, const Shard& shard);

}  // namespace rigid_body_sim
