#pragma once

#include <optional>
#include <string>

namespace rigid_body_sim {

/// What the command line of `simulate` says; absent means as the scene says.
struct SimulateOptions {
  std::string scene;
  std::optional<double> duration;         ///< [s] > 0
  std::optional<double> sample;           ///< [s] > 0, time between rows
  std::optional<double> time_step;        ///< [s] > 0
  std::optional<double> tolerance;        ///< > 0
  std::optional<int> threads;             ///< >= 1
  std::optional<std::string> integrator;  ///< a name of the catalogue
  std::optional<std::string> csv;         ///< file; "-": standard output
  std::optional<std::string> imu_csv;     ///< likewise
  std::optional<std::string> bag;         ///< file
  std::optional<std::string> plot;        ///< directory
  std::optional<std::string> wrench_bag;  ///< file
  std::optional<std::string> save, load;  ///< files of states
  bool help = false;
};

/// Throws UsageError for an unknown option or integrator, a value that is no number > 0, or no
/// scene, and where two outputs are the standard output.
SimulateOptions parseSimulateOptions(int argc, char** argv);

/// The text of --help.
std::string simulateHelp();

}  // namespace rigid_body_sim
