#pragma once

#include <cstdio>
#include <string>

namespace rigid_body_sim {

/// A CSV file that is written; each function throws std::runtime_error, the path first, when the
/// file takes no more, as on a full disk.
class CsvFile {
 public:
  /// Writes the header. Path "-": standard output.
  CsvFile(const std::string& path, const char* header);
  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  std::FILE* stream() const { return file_; }

  /// After rows were written: a disk that is full now will not take the rest either.
  void check() const;

  /// Makes sure that every row has reached the file.
  void finish();

 private:
  [[noreturn]] void fail() const;

  std::string path_;
  std::FILE* file_;
};

}  // namespace rigid_body_sim
