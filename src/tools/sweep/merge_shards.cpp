#include "tools/sweep/merge_shards.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

#include "programs/make_directory.hpp"
#include "tools/sweep/kept_rows.hpp"
#include "tools/sweep/other_tables.hpp"
#include "tools/sweep/run_table.hpp"
#include "tools/sweep/shard_set.hpp"
#include "tools/sweep/sweep_job.hpp"
#include "tools/sweep/table_lines.hpp"

namespace rigid_body_sim {
namespace {

namespace fs = std::filesystem;

/// A table of a shard that is read.
struct OpenShard {
  const ShardTable& shard;
  TableLines lines;
  std::uint64_t digest = 0;  // of the rows that were read
  std::int64_t rows = 0;     // that were read
};

/// Refuses rows which are not those that a shard has written, and what is behind them.
void requireWritten(const std::vector<OpenShard>& tables, const std::string& stem,
                    const std::string& header) {
  const auto columns = static_cast<std::size_t>(std::count(header.begin(), header.end(), ',') + 1);
  for (const OpenShard& table : tables) {
    const auto& [sweep, ledger, lost] = table.shard.info;
    if (!table.lines.isAtEnd()) refuseMoreThan(table.lines.path(), table.rows);
    if (stem == "runs")
      requireLedger(table.shard.files, ledger, table.digest,
                    {columns, sweep.varied, sweep.records});
    else
      requireFan(table.lines.path(), ledger, table.digest);
  }
}

/// One line of each table in turn, as long as there are any. Shards differ by one row at most.
/// False where it is told to stop.
bool interleave(const std::vector<ShardTable>& shards, const std::string& stem,
                const std::string& out, const std::atomic<bool>& stop) {
  constexpr std::size_t kAllPieces = 16 << 20;
  const std::size_t piece =
      std::clamp<std::size_t>(kAllPieces / shards.size(), 4096, TableLines::kPiece);
  std::vector<OpenShard> tables;
  std::string line, header;
  for (const ShardTable& shard : shards) {
    tables.push_back({shard, TableLines(shard.files.path(stem, ".csv"), piece)});
    TableLines& lines = tables.back().lines;
    if (tables.size() == 1 && !lines.next(header, std::string::npos))
      throw std::runtime_error(lines.path() + ": cannot be read");
    if (tables.size() > 1 && (!lines.next(line, header.size()) || line != header))
      throw std::runtime_error(lines.path() + ":1: has other columns than " +
                               tables.front().lines.path());
  }
  RunTable merged = RunTable::create(LockedFile(out), header);
  const std::size_t longest = longestRow(header);
  std::string rows;
  bool any = true;
  for (std::int64_t row = 0; any; ++row) {
    if (stop) return false;
    any = false;
    for (OpenShard& table : tables)
      if (table.lines.next(line, longest)) {
        requireRowInPlace(table.lines.path(), row, line, table.shard.files.shard);
        table.digest += digestOfRow(line);
        ++table.rows;
        any = true;
        rows += line + "\n";
      }
    if (rows.size() < TableLines::kPiece && any) continue;
    merged.append(rows);
    rows.clear();
  }
  requireWritten(tables, stem, header);
  return true;
}

/// The tables that are made in a directory, beside those that are there until they are whole.
class MergedTables {
 public:
  /// Throws std::runtime_error where a sweep writes them, or where they are not of a sweep.
  MergedTables(const fs::path& directory, bool has_fan)
      : directory_(checked(directory, has_fan)), lock_((directory / "runs.csv").string()) {
    if (has_fan) stems_.push_back("fan");
    for (const std::string& stem : stems_) requireTableOfASweep(part(stem), stem);
  }

  MergedTables(const MergedTables&) = delete;
  MergedTables& operator=(const MergedTables&) = delete;

  /// Removes what is not whole.
  ~MergedTables() {
    std::error_code is_gone;
    for (const std::string& stem : stems_) fs::remove(part(stem), is_gone);
    if (lock_.isNew() && !is_in_place_) fs::remove(lock_.path(), is_gone);
  }

  const std::vector<std::string>& stems() const { return stems_; }
  std::string part(const std::string& stem) const { return path(stem) + ".part"; }

  void putInPlace() {
    removeOldResults({Shard{}, directory_}, stems_.size() > 1);
    for (const std::string& stem : stems_) fs::rename(part(stem), path(stem));
    is_in_place_ = true;
  }

 private:
  /// Before the table is made where it is not there.
  static const fs::path& checked(const fs::path& directory, bool has_fan) {
    requireFilesOfASweep({Shard{}, directory}, has_fan);
    return directory;
  }
  std::string path(const std::string& stem) const {
    return (directory_ / (stem + ".csv")).string();
  }

  fs::path directory_;
  LockedFile lock_;
  std::vector<std::string> stems_{"runs"};
  bool is_in_place_ = false;
};

}  // namespace

std::optional<TableInfo> mergeShards(const std::vector<std::string>& directories,
                                     const std::string& out, const std::atomic<bool>& stop) {
  const std::vector<ShardTable> shards = shardsIn(directories);
  TableInfo info{shards.front().info.sweep, {}};
  for (const auto& [files, there] : shards) {
    info.ledger.add(there.ledger);
    if (there.ledger.is_other) SweepJob::notify(noticeOfOtherRows(files));
  }
  makeDirectory(out);
  MergedTables tables(out, !info.sweep.fan.empty());
  for (const std::string& stem : tables.stems())
    if (!interleave(shards, stem, tables.part(stem), stop)) return std::nullopt;
  tables.putInPlace();
  writeText((fs::path(out) / "runs.info").string(), toText(info));
  return info;
}

}  // namespace rigid_body_sim
