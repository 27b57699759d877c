#pragma once

#include <string>

#include "tools/sweep/shard.hpp"

namespace rigid_body_sim {

/// Throws std::runtime_error where a directory holds tables of another number of shards than this
/// one is of: runs would be made twice, and the tables could not be merged.
void refuseOtherDivisions(const std::string& directory, const Shard& shard);

/// Throws std::runtime_error for a file that no sweep may have written: there is one, something is
/// in it, and it is no table. stem: runs or fan.
void requireTableOfASweep(const std::string& path, const std::string& stem);

/// Removes what was made of another table in a directory: summary, plot, and the fan where the new
/// one has none.
void removeOldResults(const ShardFiles& files, bool has_fan);

}  // namespace rigid_body_sim
