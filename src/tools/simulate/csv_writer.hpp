#pragma once

#include <string>

#include <rigid_body_sim/dynamics/world.hpp>

#include "tools/simulate/csv_file.hpp"

namespace rigid_body_sim {

/// Writes states as CSV, a row for each body, 17 significant digits: enough to get the same double
/// back.
class CsvWriter {
 public:
  /// See CsvFile, for the others, too.
  explicit CsvWriter(const std::string& path);
  void write(const World& world, const State& state);
  void finish() { file_.finish(); }

 private:
  CsvFile file_;
};

}  // namespace rigid_body_sim
