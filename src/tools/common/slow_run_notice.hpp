#pragma once

#include <chrono>
#include <cstdint>
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

  /// The step after which the clock is to be read again, about a tenth of a second from now: to be
  /// asked for the text before is in vain. Also once it is said, so that who steps up to there is
  /// seen to go on.
  std::int64_t nextLook() const { return next_look_; }

  /// To be called after every step, or after that one; reads the clock some ten times a second.
  /// Returns the text when it is time for it, else nothing.
  std::string textIfDue(const Simulation& simulation);

 private:
  double t_end_;
  double patience_;
  using Clock = std::chrono::steady_clock;
  void planLook(std::int64_t steps, Clock::time_point now);

  Clock::time_point begin_ = Clock::now(), last_look_ = begin_;
  std::int64_t looked_at_ = 0;  // steps at the last look
  std::int64_t next_look_ = 0;  // step at which to read the clock
  bool is_said_ = false;
};

}  // namespace rigid_body_sim
