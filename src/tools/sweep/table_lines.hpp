#pragma once

#include <cstddef>
#include <cstdint>
#include <ios>
#include <string>

namespace rigid_body_sim {

/// The lines of a table, read piece by piece: in memory that does not grow with what is in the
/// file, and without keeping it open, as there may be more shards than files that a process may
/// have open.
class TableLines {
 public:
  static constexpr std::size_t kPiece = 1 << 17;

  /// piece: bytes that are read at once.
  explicit TableLines(std::string path, std::size_t piece = kPiece);

  const std::string& path() const { return path_; }

  /// False at the end; what has no end of line is none. A line of more than `most` bytes is cut
  /// after one more, as something that is no line of a table, whatever follows.
  bool next(std::string& line, std::size_t most);

  /// Whether nothing is left of what was read: at the end, whether the last line had one.
  bool isAtEnd() const { return begin_ == text_.size(); }

  /// Up to the end of the line before.
  std::int64_t bytes() const { return bytes_; }

 private:
  bool readOn();

  std::string path_;
  std::size_t piece_;
  std::streamoff offset_ = 0;  // of what is to be read next
  std::string text_;
  std::size_t begin_ = 0;  // in the text, of the next line
  std::int64_t bytes_ = 0;
};

/// More bytes than a row has in a table with this header.
std::size_t longestRow(const std::string& header);

}  // namespace rigid_body_sim
