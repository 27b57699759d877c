#pragma once

#include <cstdint>
#include <string>

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <rigid_body_sim/SimStatus.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// What the node knows of its run, beside the simulation.
struct RunFigures {
  std::int64_t overruns = 0;
  std::int64_t refused = 0;  ///< inputs of any kind
  bool paused = false;
  std::string divergence;  ///< time, body and quantity, once the simulation has stopped
};

/// The state of the simulation in figures; stamp and real-time factor are left to the caller.
/// Energy and momenta are those of totalsOf; balances are not numbers unless they are tracked.
SimStatus toSimStatus(const Simulation& simulation, const RunFigures& figures);

/// Whether an attitude error estimated at a time is one that auto promises: nothing is promised
/// beyond the horizon, or of an integrator that the scene names. The position is not judged: its
/// error is promised relative to the length of the path, which nobody keeps.
bool isWithinTolerance(const ErrorEstimate& error, double time, const SolverOptions& solver);

/// Whether auto found a row that holds the scene's tolerance wherever it needed one, and no
/// attitude error was estimated that exceeds it.
bool holdsTolerance(const Simulation& simulation);

struct Health {
  SimStatus status;
  std::uint64_t new_overruns = 0;  ///< since the last report
  bool holds_tolerance = true;
  std::string divergence;  ///< as in RunFigures
};

/// ERROR once the simulation has stopped; WARN for new overruns, for steps taken in parts, and for
/// a tolerance that is not held; and the figures.
void describe(const Health& health, diagnostic_updater::DiagnosticStatusWrapper& diagnostic);

}  // namespace rigid_body_sim
