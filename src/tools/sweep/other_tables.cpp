#include "tools/sweep/other_tables.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "tools/sweep/run_table.hpp"
#include "tools/sweep/sweep_info.hpp"
#include "tools/sweep/sweep_plot.hpp"
#include "tools/sweep/sweep_summary.hpp"

namespace rigid_body_sim {
namespace {

namespace fs = std::filesystem;

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

/// Reads a line, of which the last bytes are kept; whether it has an end.
bool readLineEnd(std::istream& in, std::size_t most, std::string& last) {
  std::array<char, 1 << 12> block{};
  while (in.read(block.data(), block.size()) || in.gcount() > 0) {
    const char* const block_end = block.data() + in.gcount();
    const char* const line_end = std::find<const char*>(block.data(), block_end, '\n');
    last.append(block.data(), static_cast<std::size_t>(line_end - block.data()));
    last.erase(0, last.size() - std::min(last.size(), most));
    if (line_end != block_end) return true;
  }
  return false;
}

/// Whether a sweep may have written the file, as its first line says, however long that is.
bool isTableOfASweep(const std::string& path, const std::string& stem) {
  const std::string head = "run,", tail = ",attitude_error,position_error,status";
  const std::string begin = beginOf(path, head.size()).value_or("");
  if (begin.empty()) return true;
  std::ifstream in(path, std::ios::binary);
  std::string last;
  // the header may be cut where a disk was full
  const bool is_whole = readLineEnd(in, tail.size(), last);
  return begin == head.substr(0, begin.size()) && (stem != "runs" || !is_whole || last == tail);
}

/// Throws for a file that a test on its first bytes does not take for one of a sweep.
template <class IsOfASweep>
void requireBegin(const std::string& path, const IsOfASweep& isOfASweep) {
  constexpr std::size_t kMaxBytes = 1024;
  const std::string begin = beginOf(path, kMaxBytes).value_or("");
  if (!begin.empty() && !isOfASweep(begin))
    throw std::runtime_error(
        path + ": is not of a sweep, and would be replaced; remove it, or name another --out");
}

/// Which may be cut where a disk was full.
auto beginsWith(const std::string& mark) {
  return [mark](const std::string& begin) {
    return begin.compare(0, mark.size(), mark, 0, begin.size()) == 0;
  };
}

bool isPlotOfASweep(const std::string& begin) { return begin.find(kPlotMark) != std::string::npos; }

}  // namespace

void refuseOtherDivisions(const std::string& directory, const Shard& shard) {
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

void requireRegular(const std::string& path) {
  std::error_code fault;
  const fs::file_status there = fs::status(path, fault);
  // such as a link to itself
  if (!fs::status_known(there))
    throw std::runtime_error(path + ": cannot be read: " + fault.message() +
                             "; remove it, or name another --out");
  if (fs::exists(there) && !fs::is_regular_file(there))
    throw std::runtime_error(path + ": is no regular file");
}

void requireTableOfASweep(const std::string& path, const std::string& stem) {
  requireRegular(path);
  if (!isTableOfASweep(path, stem))
    throw std::runtime_error(
        path + ": is no table of a sweep, and would be replaced; remove it, or name another --out");
}

void requireFilesOfASweep(const ShardFiles& files, bool has_fan) {
  requireTableOfASweep(files.path("runs", ".csv"), "runs");
  if (has_fan) requireTableOfASweep(files.path("fan", ".csv"), "fan");
  const std::string info = files.path("runs", ".info");
  requireRegular(info);
  requireBegin(info, beginsWith(kInfoMark));
  if (files.shard.count > 1) return;
  const std::string summary = (files.directory / "summary.csv").string(),
                    plot = (files.directory / "sweep.svg").string();
  for (const std::string& path : {summary, plot}) requireRegular(path);
  requireBegin(summary, beginsWith(kSummaryMark));
  requireBegin(plot, isPlotOfASweep);
}

void requireSceneOfASweep(const std::string& path) {
  std::error_code is_gone;
  // a pipe may be written, too
  if (fs::is_regular_file(path, is_gone)) requireBegin(path, beginsWith("# run "));
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
    if (fs::is_regular_file(path, kept)) fs::remove(path, kept);
}

}  // namespace rigid_body_sim
