#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/sweep/sweep_ledger.hpp"

namespace rigid_body_sim {

/// What tells one sweep from another, and what its columns are; beside every table as runs.info, so
/// that what is resumed and merged belongs together.
struct SweepInfo {
  std::string title;         ///< the names of scene and study
  std::uint64_t digest = 0;  ///< of scene, study and options
  std::int64_t runs = 0;     ///< of all shards
  std::size_t varied = 0;    ///< columns after the first
  std::size_t records = 0;   ///< columns before the last three
  std::string fan;           ///< quantity of fan.csv; empty: none

  /// Rows of fan.csv, of all shards: the first runs have one.
  static constexpr std::int64_t kFanRuns = 1000;
  std::int64_t fanRuns() const { return fan.empty() ? 0 : std::min(runs, kFanRuns); }
};

/// What stands beside a table.
struct TableInfo {
  SweepInfo sweep;
  SweepLedger ledger{};  ///< of the rows that are known to be whole
  LostRows lost{};       ///< until they are there again
};

/// One line per member, and a last one that seals them; and back. Of a text that is not what was
/// written, to the last byte: nothing.
std::string toText(const TableInfo& info);
std::optional<TableInfo> tableInfoIn(const std::string& text);

/// Why the text of a file, or no file, is none, such as "is not there".
std::string faultOfInfo(const std::optional<std::string>& text);

/// With which the text begins, whatever version wrote it.
constexpr const char* kInfoMark = "rigid_body_sim sweep ";

/// More bytes than it has.
constexpr std::size_t kMaxInfoBytes = 1 << 20;

/// Whether their rows belong together, whatever the names of their files.
bool isSameSweep(const SweepInfo& a, const SweepInfo& b);

/// A hash of texts, one after the other.
std::uint64_t digestOf(const std::vector<std::string>& texts);

}  // namespace rigid_body_sim
