#pragma once

#include <chrono>
#include <cstdint>

namespace rigid_body_sim {

/// Ties simulation time to the steady clock. A late step is taken late and never stretched; what
/// has fallen behind by more than the backlog limit is dropped, not caught up.
class Pacer {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr double kBacklogLimit = 0.25;  ///< [s] of wall time

  /// real_time_factor: simulated / wall time; 0: every step is due at once.
  explicit Pacer(double real_time_factor) : real_time_factor_(real_time_factor) {}

  /// Simulation time t [s] is now.
  void restart(double t, Clock::time_point now);

  /// Another factor from now on: time runs on from where it is. next [s]: the time that the next
  /// step reaches. It stays due where it is; later ones are not, so that what has fallen behind at
  /// the old factor is not caught up at the new one.
  void setFactor(double real_time_factor, double next, Clock::time_point now);

  /// Wall time [s] from now until the step that reaches t is due; not above 0: it is.
  double wait(double t, Clock::time_point now) const;

  /// The step from t − h to t begins now. Late by more than its own length: an overrun.
  void begin(double t, double h, Clock::time_point now);

  /// Simulation time t [s] is due now. What has fallen behind by more than the limit is dropped.
  void dropBacklog(double t, Clock::time_point now);

  std::int64_t overruns() const { return overruns_; }

 private:
  double real_time_factor_;
  double origin_t_ = 0;
  Clock::time_point origin_;
  std::int64_t overruns_ = 0;
};

}  // namespace rigid_body_sim
