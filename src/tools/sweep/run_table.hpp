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

  /// A file of this header, whose first rows, as many as asked for, are kept and whose rest is cut
  /// off. Throws std::runtime_error where it is another table, or has a row at the place of
  /// another.
  static RunTable reopen(LockedFile file, const std::string& header, std::int64_t rows,
                         const Shard& shard);

  /// Whole rows. Throws std::runtime_error, and leaves the table as it was, where the file does not
  /// take them.
  void append(const std::string& rows) { file_.append(rows); }

 private:
  explicit RunTable(LockedFile file) : file_(std::move(file)) {}

  LockedFile file_;
};

/// Throws std::runtime_error for the row number `row` of a shard's table, from 0 on, that is not of
/// the run that belongs there.
void requireRowInPlace(const std::string& path, std::int64_t row, const std::string& line,
                       const Shard& shard);

/// Whole rows of a table after its header; 0 where there is no file.
std::int64_t wholeRows(const std::string& path);

/// Whether a sweep may have written the file, which is not another's then: there is none, nothing
/// in it, or a table. stem: runs or fan.
bool isTableOfASweep(const std::string& path, const std::string& stem);

/// Throws std::runtime_error where it is not.
void requireTableOfASweep(const std::string& path, const std::string& stem);

/// The whole text of a small file; none where there is no file.
std::optional<std::string> textOf(const std::string& path);

/// Writes a small file. Throws std::runtime_error.
void writeText(const std::string& path, const std::string& text);

}  // namespace rigid_body_sim
