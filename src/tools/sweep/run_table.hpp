#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "tools/sweep/locked_file.hpp"
#include "tools/sweep/shard.hpp"

namespace rigid_body_sim {

/// A table in a file that at every instant holds whole rows only: each append is one write, and
/// what a full disk cuts off is taken away again.
class RunTable {
 public:
  /// Of a header line, in place of what was there. Throws std::runtime_error where it cannot be
  /// written.
  static RunTable create(LockedFile file, const std::string& header);

  /// What is there, up to so many bytes.
  static RunTable reopen(LockedFile file, std::int64_t bytes);

  /// Whole rows. Throws std::runtime_error, and leaves the table as it was, where the file does not
  /// take them.
  void append(const std::string& rows) { file_.append(rows); }

  /// Throws std::runtime_error where it is no longer the file of its path, or of another length.
  void requireInPlace() const { file_.requireInPlace(); }

 private:
  explicit RunTable(LockedFile file) : file_(std::move(file)) {}

  LockedFile file_;
};

/// What is known of rows that were read.
struct RowsRead {
  std::uint64_t digest = 0;
  std::int64_t bytes = 0;  ///< up to their end, with the header
};

/// Reads the first rows of a table. Throws std::runtime_error where it has another header, fewer
/// rows, or one at the place of another.
RowsRead readRows(const std::string& path, const std::string& header, std::int64_t rows,
                  const Shard& shard);

/// Throws std::runtime_error for the row number `row` of a shard's table, from 0 on, that is not of
/// the run that belongs there.
void requireRowInPlace(const std::string& path, std::int64_t row, const std::string& line,
                       const Shard& shard);

/// Whole rows of a table after its header; 0 where there is no file.
std::int64_t wholeRows(const std::string& path);

/// The first bytes of a file, at most so many; none where there is no file.
std::optional<std::string> beginOf(const std::string& path, std::size_t most);

/// Writes a small file, which is there as a whole or as it was before. Throws WriteError.
void writeText(const std::string& path, const std::string& text);

/// Writes a text over that of a file, without room for another; where it cannot, it stays away.
void overwriteText(const std::string& path, const std::string& text);

}  // namespace rigid_body_sim
