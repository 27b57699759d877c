#pragma once

#include <atomic>
#include <string>

namespace rigid_body_sim {

/// While this lives, an interrupt, a request to end or the loss of the terminal is kept for later,
/// once; the second one ends the process at once.
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

  /// From now on a signal ends the process at once, and so does one that has come; before, it
  /// writes a line, which has its end, to the standard error.
  void endAtOnce(std::string line);

 private:
  std::string last_words_;
};

}  // namespace rigid_body_sim
