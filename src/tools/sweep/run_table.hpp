#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tools/sweep/shard.hpp"

namespace rigid_body_sim {

/// A table in a file that at every instant holds whole rows only: each append is one write, and
/// what a full disk cuts off is taken away again. No other process has the same table open.
class RunTable {
 public:
  /// A new file with a header line, in place of what was there. Throws std::runtime_error where it
  /// cannot be written, and leaves it as it was where another process has it open.
  static RunTable create(const std::string& path, const std::string& header);

  /// A file of this header, whose first rows, as many as asked for, are kept and whose rest is cut
  /// off. Throws std::runtime_error where it is another table, open in another process, or has a
  /// row at the place of another.
  static RunTable reopen(const std::string& path, const std::string& header, std::int64_t rows,
                         const Shard& shard);

  RunTable(RunTable&& other) noexcept;
  RunTable& operator=(RunTable&&) = delete;
  ~RunTable();

  /// Whole rows. Throws std::runtime_error, and leaves the table as it was, where the file does not
  /// take them.
  void append(const std::string& rows);

 private:
  RunTable(std::string path, int flags);
  void cutTo(std::int64_t bytes);

  std::string path_;
  int descriptor_;
};

/// Throws std::runtime_error for the row number `row` of a shard's table, from 0 on, that is not of
/// the run that belongs there.
void requireRowInPlace(const std::string& path, std::int64_t row, const std::string& line,
                       const Shard& shard);

/// Whole rows of a table after its header; 0 where there is no file.
std::int64_t wholeRows(const std::string& path);

/// The whole text of a small file; none where there is no file.
std::optional<std::string> textOf(const std::string& path);

/// Writes a small file. Throws std::runtime_error.
void writeText(const std::string& path, const std::string& text);

}  // namespace rigid_body_sim
