#include "tools/sweep/other_tables.hpp"

#include <filesystem>
#include <stdexcept>

namespace rigid_body_sim {
namespace {

/// "all runs", "shard 2 of 4"
std::string inWords(const Shard& shard) {
  if (shard.count == 1) return "all runs";
  return "shard " + std::to_string(shard.index) + " of " + std::to_string(shard.count);
}

[[noreturn]] void refuse(const std::string& table, const Shard& other, const Shard& shard) {
  throw std::runtime_error(
      table + ": is of " + inWords(other) + ", and here " + inWords(shard) +
      " would be made; --shard I/N or RIGID_BODY_SIM_SHARDS=N divides as before, "
      "or name another --out, or remove it");
}

}  // namespace

void refuseOtherDivisions(const std::string& directory, const Shard& shard) {
  namespace fs = std::filesystem;
  bool has_same = false;
  for (const fs::directory_entry& file : fs::directory_iterator(directory)) {
    const auto other = shardOfTable(file.path().filename().string());
    if (other && other->count != shard.count) refuse(file.path().string(), *other, shard);
    has_same |= other.has_value();
  }
  // beside shards it is what they were merged to
  const fs::path whole = fs::path(directory) / Shard{}.fileName("runs", ".csv");
  std::error_code is_gone;
  if (shard.count > 1 && !has_same && fs::exists(whole, is_gone))
    refuse(whole.string(), Shard{}, shard);
}

}  // namespace rigid_body_sim
