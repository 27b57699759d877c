#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "programs/looking_thread.hpp"

namespace rigid_body_sim {

/// Says so, once, where a single step, or what comes before the first, is computed for longer than
/// a user waits without a word. Results do not depend on it.
class StepWatch {
 public:
  /// What has not been done, "ended the step from t = 0.1 s: …", by what begin or goOn was given.
  using What = std::function<std::string(double)>;
  static std::string step(double t);

  /// say(text): called by a thread of its own. patience [s] of wall time.
  explicit StepWatch(std::function<void(const std::string&)> say, double patience = 10,
                     What what = step);

  static constexpr double kBeforeTheRun = -1;

  /// A step from t [s] begins, or with kBeforeTheRun what comes before the first: no clock is read.
  void begin(double t) {
    time_.store(t, std::memory_order_relaxed);
    begun_.fetch_add(1, std::memory_order_relaxed);
    is_busy_.store(true, std::memory_order_relaxed);
  }

  /// The same as before is still computed, and has come as far as that.
  void goOn(double t) { time_.store(t, std::memory_order_relaxed); }

  /// Nothing is computed from now on.
  void end() { is_busy_.store(false, std::memory_order_relaxed); }

 private:
  bool look();

  std::function<void(const std::string&)> say_;
  double patience_;
  What what_;
  std::atomic<double> time_{0};
  std::atomic<std::uint64_t> begun_{0};
  std::atomic<bool> is_busy_{false};
  std::uint64_t seen_ = 0;  // by the thread, like the next
  int same_ = 0;            // looks that have found the same
  LookingThread thread_;    // the last: it sees the others
};

}  // namespace rigid_body_sim
