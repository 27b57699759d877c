#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <string>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// Says once, after ten seconds of computing, that a run takes long and why: steps that are divided
/// because a body turns fast, a solved motion of many turns a step, or a great number of steps.
/// Results do not depend on it.
class SlowRunNotice {
 public:
  /// t_end [s]: where the run ends. patience [s] of wall time.
  explicit SlowRunNotice(double t_end, double patience = 10) : t_end_(t_end), patience_(patience) {}

  /// The step after which the text may be due: to be asked for it before is in vain.
  std::int64_t nextLook() const { return is_said_ ? kNever : next_look_; }

  /// To be called after every step, or after that one; reads the clock some ten times a second.
  /// Returns the text when it is time for it, else nothing.
  std::string textIfDue(const Simulation& simulation);

 private:
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

  double t_end_;
  double patience_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::int64_t next_look_ = 0;  // step at which to read the clock
  bool is_said_ = false;
};

}  // namespace rigid_body_sim
