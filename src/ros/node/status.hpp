#pragma once

#include <cstdint>
#include <string>

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <rigid_body_sim/SimStatus.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// How a run fares. The node fills in overruns, refused, paused,
/// requested_real_time_factor and divergence; the rest follows
/// from the simulation.
struct Health {
  SimStatus status;
  std::uint64_t new_overruns = 0;  ///< since the last report
  bool holds_tolerance = true;
  std::string divergence;  ///< time, body and quantity, once the simulation has stopped
};

/// Fills in the state of the simulation in figures; stamp and real-time factor are left to the
/// caller. Energy and momenta are those of totalsOf; balances are not numbers unless tracked.
void addFigures(const Simulation& simulation, SimStatus& status);

/// Whether an attitude error estimated at a time [s] of the horizon is one that auto promises:
/// nothing is promised beyond the horizon, or of an integrator that the scene names. The position
/// is not judged: its error is promised relative to the length of the path, which nobody keeps.
bool isWithinTolerance(const ErrorEstimate& error, double time, const SolverOptions& solver);

/// Whether auto found an integrator that holds the scene's tolerance wherever it needed one, and no
/// attitude error was estimated that exceeds it.
bool holdsTolerance(const Simulation& simulation);

/// ERROR once the simulation has stopped; WARN for new overruns, for steps taken in substeps, and
/// for a tolerance that is not held; and the figures.
void describe(const Health& health, diagnostic_updater::DiagnosticStatusWrapper& diagnostic);

}  // namespace rigid_body_sim
