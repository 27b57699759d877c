#pragma once

#include <memory>
#include <string>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/scene.hpp>

#include "tools/common/deferred_messages.hpp"
#include "tools/simulate/bag_output.hpp"
#include "tools/simulate/csv_writer.hpp"
#include "tools/simulate/imu_csv.hpp"
#include "tools/simulate/plot_files.hpp"
#include "tools/simulate/recorded_run.hpp"
#include "tools/simulate/simulate_options.hpp"

namespace rigid_body_sim {

/// One call of the program: what it reads, computes and writes.
struct SimulateJob {
  /// Reads the scene. Throws UsageError where a file would be two at once, or for options that the
  /// scene does not go with.
  explicit SimulateJob(const SimulateOptions& given);

  /// Reads the state and the record that the run begins with, and finds its begin and end.
  void openInputs();

  /// Opens the files that it writes: one that takes nothing is reported before the run.
  void openOutputs();

  void note(const std::string& text);

  SimulateOptions options;
  Scene scene;
  World world;
  Simulation simulation;
  State first;
  DeferredMessages messages;
  std::unique_ptr<RecordedRun> record;  ///< of --wrench-bag
  double begin = 0, end = 0;            ///< [s]
  double sample = 0;                    ///< [s]
  std::unique_ptr<CsvWriter> csv;
  std::unique_ptr<ImuCsv> imu_csv;
  std::unique_ptr<BagOutput> bag;
  std::unique_ptr<PlotFiles> plot;

 private:
  void openRecord(const std::string& path);
  void load(const std::string& path);
  void checkTimes() const;
  void openImuCsv();
};

}  // namespace rigid_body_sim
