#include "tools/sweep/other_tables.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

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

/// Whether a sweep may have written the file.
bool isTableOfASweep(const std::string& path, const std::string& stem) {
  std::error_code is_gone;
  // a device has no rows to lose
  if (!std::filesystem::is_regular_file(path, is_gone)) return true;
  std::ifstream in(path, std::ios::binary);
  std::string line;
  if (!std::getline(in, line)) return true;
  const std::string head = "run,", tail = ",attitude_error,position_error,status";
  // the header may be cut where a disk was full
  const bool is_whole = !in.eof();
  return line.compare(0, head.size(), head) == 0 &&
         (stem != "runs" || !is_whole ||
          (line.size() > tail.size() &&
           line.compare(line.size() - tail.size(), tail.size(), tail) == 0));
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

void requireTableOfASweep(const std::string& path, const std::string& stem) {
  if (!isTableOfASweep(path, stem))
    throw std::runtime_error(
        path + ": is no table of a sweep, and would be replaced; remove it, or name another --out");
}

void removeOldResults(const ShardFiles& files, bool has_fan) {
  std::vector<std::string> old;
  if (files.shard.count == 1)
    for (const char* name : {"summary.csv", "sweep.svg"})
      old.push_back((files.directory / name).string());
  const std::string fan = files.path("fan", ".csv");
  if (!has_fan && isTableOfASweep(fan, "fan")) old.push_back(fan);
  std::error_code kept;
  for (const std::string& path : old)
    if (std::filesystem::is_regular_file(path, kept)) std::filesystem::remove(path, kept);
}

}  // namespace rigid_body_sim
