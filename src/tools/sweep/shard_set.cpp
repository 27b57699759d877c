#include "tools/sweep/shard_set.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>

#include "tools/sweep/kept_rows.hpp"
#include "tools/sweep/other_tables.hpp"
#include "tools/sweep/run_table.hpp"

namespace rigid_body_sim {
namespace {

namespace fs = std::filesystem;

using ShardsByNumber = std::map<std::int64_t, ShardFiles>;

void addShard(const ShardFiles& files, ShardsByNumber& shards) {
  const std::string path = files.path("runs", ".csv");
  if (!shards.empty() && files.shard.count != shards.begin()->second.shard.count)
    throw std::runtime_error(path + ": is of another number of shards than " +
                             shards.begin()->second.path("runs", ".csv"));
  const auto [other, is_new] = shards.emplace(files.shard.index, files);
  if (!is_new)
    throw std::runtime_error(path + ": is there twice, in " + other->second.directory.string() +
                             ", too");
}

ShardsByNumber filesIn(const std::vector<std::string>& directories) {
  ShardsByNumber shards;
  for (const std::string& directory : directories) {
    if (!fs::is_directory(directory)) throw std::runtime_error(directory + ": is no directory");
    for (const fs::directory_entry& file : fs::directory_iterator(directory))
      if (const auto shard = shardOfTable(file.path().filename().string()))
        addShard({*shard, directory}, shards);
  }
  // a sweep that was not divided
  if (shards.empty() && fs::exists(fs::path(directories.front()) / "runs.csv"))
    shards.emplace(1, ShardFiles{Shard{}, directories.front()});
  if (shards.empty())
    throw std::runtime_error(directories.front() +
                             ": has no table of a shard, such as runs.1of4.csv");
  return shards;
}

void requireAll(const ShardsByNumber& shards) {
  constexpr std::int64_t kMaxNamed = 20;
  const std::int64_t count = shards.begin()->second.shard.count;
  const std::int64_t missing = count - static_cast<std::int64_t>(shards.size());
  if (missing == 0) return;
  std::string names;
  std::int64_t named = 0;
  for (std::int64_t i = 1; i <= count && named < kMaxNamed; ++i) {
    if (shards.count(i) > 0) continue;
    names += (named++ > 0 ? ", " : "") + Shard{i, count}.fileName("runs", ".csv");
  }
  if (missing > named) names += " and " + std::to_string(missing - named) + " others";
  throw std::runtime_error(
      names + (missing == 1 ? ": this shard is missing" : ": these shards are missing"));
}

TableInfo infoOf(const ShardFiles& files) {
  const std::string path = files.path("runs", ".info");
  requireRegular(path);
  const std::optional<std::string> text = beginOf(path, kMaxInfoBytes);
  const auto info = tableInfoIn(text.value_or(""));
  if (!info) throw std::runtime_error(path + ": " + faultOfInfo(text));
  return *info;
}

void requireRows(const std::string& path, std::int64_t rows, std::int64_t all) {
  if (rows > all) refuseMoreThan(path, all);
  if (rows < all)
    throw std::runtime_error(path + ": has " + std::to_string(rows) + " of " + std::to_string(all) +
                             " rows; finish it with --resume");
}

}  // namespace

std::vector<ShardTable> shardsIn(const std::vector<std::string>& directories) {
  const ShardsByNumber shards = filesIn(directories);
  requireAll(shards);
  std::vector<ShardTable> tables;
  for (const auto& [number, files] : shards) {
    for (const char* stem : {"runs", "fan"}) requireRegular(files.path(stem, ".csv"));
    tables.push_back({files, infoOf(files)});
    const TableInfo &info = tables.back().info, &first = tables.front().info;
    const std::string path = files.path("runs", ".csv");
    if (!isSameSweep(info.sweep, first.sweep))
      throw std::runtime_error(path + ": is of another sweep than " +
                               tables.front().files.path("runs", ".csv"));
    const std::int64_t all = files.shard.runsOf(info.sweep.runs);
    requireRows(path, wholeRows(path), all);
    // rows that were not known to be whole when the shard was ended
    requireRows(path, info.ledger.rows, all);
    if (info.lost.rows > 0)
      throw std::runtime_error(path +
                               ": had lost rows, and was ended before those that were made "
                               "again were checked; finish it with --resume");
    if (info.sweep.fan.empty()) continue;
    const std::string fan = files.path("fan", ".csv");
    const std::int64_t fan_rows = files.shard.runsOf(info.sweep.fanRuns());
    requireRows(fan, wholeRows(fan), fan_rows);
    if (fan_rows > 0 && !info.ledger.knowsFan())
      throw std::runtime_error(fan +
                               ": its rows were made again, and that was ended before runs.info "
                               "had them; finish it with --resume");
  }
  return tables;
}

}  // namespace rigid_body_sim
