#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigid_body_sim {

/// Runs of which there is something to say.
struct NotedRuns {
  std::int64_t count = 0;
  std::int64_t first = 0;  ///< its number
  std::string why;         ///< of the first
  /// There may be more: of rows that are left where others were lost not all is known.
  bool is_at_least = false;

  void add(std::int64_t run, const std::string& reason);
  void add(const NotedRuns& more);
};

/// What must be known of the rows of a table, or of a part of it, without reading them.
struct SweepLedger {
  /// Runs that are named at most.
  static constexpr std::size_t kMaxNamed = 1000;

  std::int64_t rows = 0;
  std::uint64_t digest = 0, fan_digest = 0;  ///< the sums over their rows
  NotedRuns refused;                         ///< without a result
  NotedRuns doubtful;                        ///< their error is beyond the tolerance, or unknown
  std::vector<std::int64_t> doubtful_runs;   ///< the first of them, by their numbers
  bool is_other = false;  ///< with rows that were lost and made again they are not as they were

  /// Whether the digest of the fan is one: while rows of it are made again there is none.
  bool knowsFan() const { return fan_digest != 0; }

  void addDoubt(std::int64_t run, const std::string& reason);

  /// Of the first rows of a table what is known of their doubtful runs, by the ledger of all: those
  /// of which the numbers are less than an end.
  void addDoubtsBefore(std::int64_t end, const SweepLedger& all);

  /// Of two parts what is known of both: in any order the same.
  void add(const SweepLedger& more);
};

/// Rows that there were where some of them were lost: made again, they must be the same.
struct LostRows {
  std::int64_t rows = 0;  ///< 0: none are lost
  std::uint64_t digest = 0;
  std::int64_t doubtful = 0;  ///< runs among them, where that is known
  bool is_at_least = false;   ///< else
};

/// A hash of a row without its end of line. Tables are told apart by the sums of those of their
/// rows, so that threads and shards need not wait for each other; each row names its run.
std::uint64_t digestOfRow(std::string_view row);

}  // namespace rigid_body_sim
