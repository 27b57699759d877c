#pragma once

#include <optional>
#include <string>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// What a run that is not solved reports of its error, which trackError estimates.
struct ErrorReport {
  /// The columns; none where nothing could be compared.
  std::optional<ErrorEstimate> estimate;
  /// Why it may be wrong by more than it should; empty: it is not known to be.
  std::string doubt;
};

/// At an end [s] that the run has come to, by whole steps or within the next.
ErrorReport errorReport(const Simulation& run, double end);

}  // namespace rigid_body_sim
