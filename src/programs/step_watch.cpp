#include "programs/step_watch.hpp"

#include <chrono>
#include <utility>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"

namespace rigid_body_sim {

StepWatch::StepWatch(std::function<void(const std::string&)> say, double patience, What what)
    : say_(std::move(say)),
      patience_(patience),
      what_(std::move(what)),
      thread_([this] { watch(); }) {}

std::string StepWatch::step(double t) {
  if (t == kBeforeTheRun)
    return "led to the first step: files are large, integrators are tried on a fast motion, or the "
           "processor is busy";
  return "ended the step from t = " + shortest(t) +
         " s: something is far faster than the time_step; if it cannot be followed, a line will "
         "say what";
}

StepWatch::~StepWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

/// Looks ten times within its patience whether the same step is still computed.
void StepWatch::watch() {
  constexpr int kLooks = 10;
  std::unique_lock<std::mutex> lock(mutex_);
  std::uint64_t seen = 0;
  for (int same = 0; same < kLooks;) {
    const std::chrono::duration<double> pause(patience_ / kLooks);
    if (changed_.wait_for(lock, pause, [this] { return ends_; })) return;
    const std::uint64_t begun = begun_.load(std::memory_order_relaxed);
    const bool is_same = is_busy_.load(std::memory_order_relaxed) && begun == seen;
    same = is_same ? same + 1 : 0;
    seen = begun;
  }
  say_(formatted("%.3g s of computing have not ", patience_) +
       what_(time_.load(std::memory_order_relaxed)));
}

}  // namespace rigid_body_sim
