#pragma once

#include <string>

#include "tools/sweep/shard.hpp"

namespace rigid_body_sim {

/// Throws std::runtime_error where a directory holds tables of another number of shards than this
/// one is of: runs would be made twice, and the tables could not be merged.
void refuseOtherDivisions(const std::string& directory, const Shard& shard);

/// Throws std::runtime_error for what there is at a path and is no regular file: a pipe is never
/// read to its end, a device may have none.
void requireRegular(const std::string& path);

/// Throws std::runtime_error for a file that a sweep would replace and that no sweep may have
/// written: something is in it, and it is no table, description, summary or plot of a sweep; or it
/// is no regular file.
void requireFilesOfASweep(const ShardFiles& files, bool has_fan);

/// The same for a table, by its path. stem: runs or fan.
void requireTableOfASweep(const std::string& path, const std::string& stem);

/// The same for the scene of a run.
void requireSceneOfASweep(const std::string& path);

/// Removes what was made of another table in a directory: summary, plot, and the fan where the new
/// one has none.
void removeOldResults(const ShardFiles& files, bool has_fan);

}  // namespace rigid_body_sim
