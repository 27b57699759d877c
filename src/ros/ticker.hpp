#pragma once

#include <cmath>
#include <limits>

namespace rigid_body_sim {

/// Events at a rate in simulation time, each at the first step that reaches it. A step that passes
/// several has one event.
class Ticker {
 public:
  /// rate [1/s] > 0
  explicit Ticker(double rate) : rate_(rate) {}

  /// Whether an event falls on simulation time t [s]; asked once for each step.
  bool due(double t) {
    // a step that misses its instant by rounding has reached it
    const double index = std::floor(t * rate_ + 1e-6);
    if (index <= last_) return false;
    last_ = index;
    return true;
  }

  void restart() { last_ = -std::numeric_limits<double>::infinity(); }

 private:
  double rate_;
  double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace rigid_body_sim
