#pragma once

#include <cstdio>
#include <string>

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Writes states as CSV, a row for each body, 17 significant digits: enough to get the same double
/// back.
class CsvWriter {
 public:
  /// Writes the header. Path "-": standard output. Throws std::runtime_error when the file cannot
  /// be opened.
  explicit CsvWriter(const std::string& path);
  ~CsvWriter();
  CsvWriter(const CsvWriter&) = delete;
  CsvWriter& operator=(const CsvWriter&) = delete;

  /// Throws std::runtime_error when the file takes no more, as on a full disk.
  void write(const World& world, const State& state);

  /// Throws std::runtime_error when not every row has reached the file.
  void finish();

 private:
  [[noreturn]] void fail() const;

  std::string path_;
  std::FILE* file_;
};

}  // namespace rigid_body_sim
