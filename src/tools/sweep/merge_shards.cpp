#include "tools/sweep/merge_shards.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "programs/make_directory.hpp"
#include "programs/usage.hpp"
#include "tools/sweep/run_table.hpp"
#include "tools/sweep/shard.hpp"

namespace rigid_body_sim {
namespace {

namespace fs = std::filesystem;

struct ShardFiles {
  Shard shard;
  fs::path directory;

  std::string path(const std::string& stem, const std::string& extension) const {
    return (directory / shard.fileName(stem, extension)).string();
  }
};

/// The shard whose table has this name, such as runs.2of4.csv; none of any other file.
std::optional<Shard> shardOf(const std::string& name) {
  const std::string head = "runs.", tail = ".csv";
  const std::size_t of = name.find("of");
  if (name.rfind(head, 0) != 0 || name.size() < head.size() + tail.size() ||
      name.substr(name.size() - tail.size()) != tail || of == std::string::npos)
    return std::nullopt;
  try {
    return parseShard(name.substr(head.size(), of - head.size()) + "/" +
                      name.substr(of + 2, name.size() - tail.size() - of - 2));
  } catch (const UsageError&) {
    return std::nullopt;
  }
}

/// By their number.
std::map<std::int64_t, ShardFiles> shardsIn(const std::vector<std::string>& directories) {
  std::map<std::int64_t, ShardFiles> shards;
  for (const std::string& directory : directories) {
    if (!fs::is_directory(directory)) throw std::runtime_error(directory + ": is no directory");
    for (const fs::directory_entry& file : fs::directory_iterator(directory)) {
      const std::optional<Shard> shard = shardOf(file.path().filename().string());
      if (!shard) continue;
      const auto [other, is_new] = shards.emplace(shard->index, ShardFiles{*shard, directory});
      if (!is_new)
        throw std::runtime_error(file.path().string() + ": is there twice, in " +
                                 other->second.directory.string() + ", too");
    }
  }
  // a sweep that was not divided
  if (shards.empty() && fs::exists(fs::path(directories.front()) / "runs.csv"))
    shards.emplace(1, ShardFiles{Shard{}, directories.front()});
  if (shards.empty())
    throw std::runtime_error(directories.front() +
                             ": has no table of a shard, such as runs.1of4.csv");
  return shards;
}

SweepInfo infoOf(const ShardFiles& files) {
  const std::string path = files.path("runs", ".info");
  const auto info = sweepInfoIn(textOf(path).value_or(""));
  if (!info) throw std::runtime_error(path + ": is not there, or not of a sweep");
  return *info;
}

void requireRows(const std::string& path, std::int64_t all) {
  const std::int64_t rows = wholeRows(path);
  if (rows != all)
    throw std::runtime_error(path + ": has " + std::to_string(rows) + " of " + std::to_string(all) +
                             " rows; finish it with --resume");
}

/// Refuses what is no whole sweep.
SweepInfo checked(const std::map<std::int64_t, ShardFiles>& shards) {
  const ShardFiles& first = shards.begin()->second;
  SweepInfo info = infoOf(first);
  for (std::int64_t i = 1; i <= first.shard.count; ++i) {
    const auto found = shards.find(i);
    const std::string name = Shard{i, first.shard.count}.fileName("runs", ".csv");
    if (found == shards.end()) throw std::runtime_error(name + ": this shard is missing");
    const ShardFiles& files = found->second;
    const std::string path = files.path("runs", ".csv");
    if (files.shard.count != first.shard.count)
      throw std::runtime_error(path + ": is of another number of shards than " +
                               first.path("runs", ".csv"));
    if (toText(infoOf(files)) != toText(info))
      throw std::runtime_error(path + ": is of another sweep than " + first.path("runs", ".csv"));
    requireRows(path, files.shard.runsOf(info.runs));
    if (!info.fan.empty())
      requireRows(files.path("fan", ".csv"), files.shard.runsOf(info.fanRuns()));
  }
  return info;
}

/// The lines of a table, read piece by piece: there may be more shards than files that a process
/// may have open.
class TableLines {
 public:
  TableLines(std::string path, std::size_t piece) : path_(std::move(path)), piece_(piece) {}

  const std::string& path() const { return path_; }

  /// False at the end.
  bool next(std::string& line) {
    std::size_t end = 0;
    while ((end = text_.find('\n', begin_)) == std::string::npos)
      if (!readOn()) return false;
    line.assign(text_, begin_, end - begin_);
    begin_ = end + 1;
    return true;
  }

 private:
  bool readOn() {
    std::ifstream in(path_, std::ios::binary);
    in.seekg(offset_);
    text_.erase(0, begin_);
    begin_ = 0;
    const std::size_t kept = text_.size();
    text_.resize(kept + piece_);
    in.read(text_.data() + kept, static_cast<std::streamsize>(piece_));
    text_.resize(kept + static_cast<std::size_t>(in.gcount()));
    offset_ += in.gcount();
    return in.gcount() > 0;
  }

  std::string path_;
  std::size_t piece_;
  std::streamoff offset_ = 0;  // of what is to be read next
  std::string text_;
  std::size_t begin_ = 0;  // in the text, of the next line
};

/// One line of each table in turn, as long as there are any. Shards differ by one row at most.
void interleave(const std::map<std::int64_t, ShardFiles>& shards, const std::string& stem,
                const std::string& out) {
  constexpr std::size_t kPiece = 1 << 20, kAllPieces = 16 << 20;
  const std::size_t piece = std::clamp<std::size_t>(kAllPieces / shards.size(), 4096, kPiece);
  std::vector<std::pair<TableLines, Shard>> tables;
  std::string line, header;
  for (const auto& [index, files] : shards) {
    tables.emplace_back(TableLines(files.path(stem, ".csv"), piece), files.shard);
    TableLines& table = tables.back().first;
    if (!table.next(line)) throw std::runtime_error(table.path() + ": cannot be read");
    if (index == 1) header = line;
    if (line != header)
      throw std::runtime_error(table.path() + ":1: has other columns than " +
                               tables.front().first.path());
  }
  RunTable merged = RunTable::create(out, header);
  std::string rows;
  bool any = true;
  for (std::int64_t row = 0; any; ++row) {
    any = false;
    for (auto& [table, shard] : tables)
      if (table.next(line)) {
        requireRowInPlace(table.path(), row, line, shard);
        any = true;
        rows += line + "\n";
      }
    if (rows.size() < kPiece && any) continue;
    merged.append(rows);
    rows.clear();
  }
}

}  // namespace

SweepInfo mergeShards(const std::vector<std::string>& directories, const std::string& out) {
  const std::map<std::int64_t, ShardFiles> shards = shardsIn(directories);
  SweepInfo info = checked(shards);
  makeDirectory(out);
  const fs::path directory = out;
  for (const char* stem : {"runs", "fan"}) {
    if (std::string(stem) == "fan" && info.fan.empty()) continue;
    const fs::path table = directory / (std::string(stem) + ".csv"),
                   part = table.string() + ".part";
    try {
      interleave(shards, stem, part.string());
      fs::rename(part, table);
    } catch (...) {
      std::error_code is_gone;
      fs::remove(part, is_gone);
      throw;
    }
  }
  writeText((directory / "runs.info").string(), toText(info));
  return info;
}

}  // namespace rigid_body_sim
