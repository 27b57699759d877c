#pragma once

#include <map>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/step_sampler.hpp>

#include "ros/outputs/instants.hpp"
#include "tools/simulate/csv_file.hpp"

namespace rigid_body_sim {

/// Writes what every IMU reads, without noise, as CSV: a row for each sample, in order of time, of
/// 17 significant digits.
class ImuCsv {
 public:
  /// The simulation is watched, not copied. For errors see CsvFile.
  ImuCsv(const std::string& path, const Simulation& simulation);

  /// Writes what is due at the step that the simulation has come to.
  void writeDue();

  /// Writes what is due before the next step, up to time t_end [s].
  void writeWithinStep(double t_end);

  /// [s] Of the next sample.
  double next() const;

  void finish() { file_.finish(); }

 private:
  void writeAt(double t, double reach);

  const Simulation& simulation_;
  std::map<double, StatesWithin> within_;  // by rate
  CsvFile file_;
  std::vector<Instants> instants_;  // IMU by IMU
};

}  // namespace rigid_body_sim
