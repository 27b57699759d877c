#include "programs/step_watch.hpp"

#include <chrono>
#include <utility>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"

namespace rigid_body_sim {
namespace {

constexpr int kLooks = 10;  // within the patience

}  // namespace

StepWatch::StepWatch(std::function<void(const std::string&)> say, double patience, What what)
    : say_(std::move(say)),
      patience_(patience),
      what_(std::move(what)),
      thread_(std::chrono::duration<double>(patience / kLooks), [this] { return look(); }) {}

std::string StepWatch::step(double t) {
  if (t == kBeforeTheRun)
    return "led to the first step: files are large, integrators are tried on a fast motion, or the "
           "processor is busy";
  return "ended the step from t = " + shortest(t) +
         " s: something is far faster than the time_step; if it cannot be followed, a line will "
         "say what";
}

/// Whether the same step is still computed.
bool StepWatch::look() {
  const std::uint64_t begun = begun_.load(std::memory_order_relaxed);
  const bool is_same = is_busy_.load(std::memory_order_relaxed) && begun == seen_;
  same_ = is_same ? same_ + 1 : 0;
  seen_ = begun;
  if (same_ < kLooks) return true;
  say_(formatted("%.3g s have not ", patience_) + what_(time_.load(std::memory_order_relaxed)));
  return false;
}

}  // namespace rigid_body_sim
