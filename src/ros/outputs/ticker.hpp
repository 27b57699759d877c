#pragma once

#include <cmath>

namespace rigid_body_sim {

/// Events at a rate in simulation time, counted from zero, each at the first step that reaches it.
/// A step that passes several has one event. Whatever was asked before, the same steps have them.
class Ticker {
 public:
  /// rate [1/s] > 0, time_step [s] > 0
  Ticker(double rate, double time_step) : rate_(rate), time_step_(time_step) {}

  /// Whether an event falls on the step that reaches simulation time t [s]; one falls on zero.
  bool due(double t) const { return eventsUntil(t) > eventsUntil(t - time_step_); }

 private:
  double eventsUntil(double t) const {
    // a step that misses its instant by rounding has reached it
    return std::floor((t + 1e-3 * time_step_) * rate_);
  }

  double rate_;
  double time_step_;
};

}  // namespace rigid_body_sim
