#pragma once

#include <atomic>

namespace rigid_body_sim {

/// While this lives, an interrupt or a request to end is kept for later, once; the second one ends
/// the process at once.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Becomes true with the signal.
  const std::atomic<bool>& requested() const;

  /// Ends the process as the signal that came would have; returns where none came.
  void endIfRequested() const;
};

}  // namespace rigid_body_sim
