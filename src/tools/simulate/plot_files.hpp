#pragma once

#include <memory>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "tools/simulate/csv_writer.hpp"

namespace rigid_body_sim {

/// The files from which a run is plotted: in one directory the CSV files of its motion, of the
/// forces on its bodies and of its energy and momentum balance.
class PlotFiles {
 public:
  /// The paths of the three in a directory.
  static std::vector<std::string> pathsIn(const std::string& directory);

  /// Makes the directory, if absent, and has the simulation, which outlives this, keep its balance.
  /// For errors see CsvFile, for the others, too.
  PlotFiles(const std::string& directory, Simulation& simulation);

  /// A state between the last step and the next. The balance is known at steps: it gets a row where
  /// one has been taken.
  void write(const State& state);
  void finish();

 private:
  void writeForces(const State& state);
  void writeBalance();

  const Simulation& simulation_;
  CsvWriter motion_;
  CsvFile forces_, balance_;
  std::int64_t balanced_steps_ = -1;
};

}  // namespace rigid_body_sim
