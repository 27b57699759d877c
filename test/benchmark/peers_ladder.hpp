#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/peers.hpp"
#include "tools/trade/cpu_time.hpp"

namespace rigid_body_sim::peers {

/// Processor time of run(start), an undisturbed one of several, each from a start of its own by
/// make().
template <class Make, class Execute>
Run timedRun(const std::string& setting, const Make& make, const Execute& execute) {
  constexpr double kBudget = 0.01;  // [s]
  constexpr int kMaxRuns = 100;
  Run run;
  run.setting = setting;
  std::vector<double> times;
  double sum = 0;
  for (int k = 0; k < kMaxRuns && sum < kBudget; ++k) {
    auto start = make();
    const double begin = cpuTime();
    execute(*start);
    times.push_back(cpuTime() - begin);
    run.q = start->motion().q;
    sum += times.back();
  }
  run.seconds = undisturbed(std::move(times));
  return run;
}

/// Hands over, one by one, what pulls at a body for the next step.
template <class World, class Apply>
void pullForStep(const Problem& problem, const World& world, const Apply& apply) {
  if (problem.isPushed()) apply({problem.force_W, problem.arm_P});
  if (!problem.spring && !problem.pulls) return;
  const Motion motion = world.motion();
  if (problem.spring) apply(pullOf(*problem.spring, motion));
  if (problem.pulls)
    for (const Pull& pull : problem.pulls(motion)) apply(pull);
}

/// The torques of wheels, step by step.
class WheelDrive {
 public:
  explicit WheelDrive(const ReactionWheels& wheels) : wheels_(wheels) {}

  /// [N m] The mean over the next step, of h.
  Array3 next(double h) {
    constexpr double kForever = std::numeric_limits<double>::infinity();
    Array3 mean{};
    for (const double end = time_ + h; time_ < end;) {
      const double until = std::min(end, wheels_.endOf(command_, kForever));
      for (std::size_t i = 0; i < 3; ++i)
        mean[i] += (until - time_) / h * wheels_.commands[command_].torque_P[i];
      time_ = until;
      if (until < end) ++command_;
    }
    return mean;
  }

 private:
  const ReactionWheels& wheels_;
  double time_ = 0;
  std::size_t command_ = 0;
};

/// Where a world is after so many steps.
template <class World>
Motion endOf(World&& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step();
  return world.motion();
}

/// Runs of an engine that is stepped from outside: make(h) returns a pointer to a new world with
/// step() and motion(). Steps from the longest [s] down to 1e-4 s, and to 1e-5 s where a method
/// of first order could then come within the next target.
template <class Make>
std::vector<Run> steppedRuns(const std::string& name, const Problem& problem, const Make& make,
                             double longest = 0.1) {
  constexpr double kShortest = 1e-4, kShortestOfAll = 1e-5;  // [s]
  constexpr double kLikely = 12;
  std::vector<Run> runs;
  double least = std::numeric_limits<double>::infinity();
  double h = longest;
  const auto runWith = [&](double step) {
    const auto steps = static_cast<std::int64_t>(std::ceil(problem.duration / step - 1e-6));
    const double exact = problem.duration / static_cast<double>(steps);
    runs.push_back(timedRun(
        label(name, "h", exact), [&] { return make(exact); },
        [&](auto& world) {
          for (std::int64_t i = 0; i < steps; ++i) world.step();
        }));
    least = std::fmin(least, errorOf(runs.back(), problem));
  };
  for (; h > 1.01 * kShortest && least > kTargets.back(); h /= 2) runWith(h);
  if (least > kTargets.back()) runWith(kShortest);
  const auto next =
      std::find_if(kTargets.begin(), kTargets.end(), [&](double t) { return t < least; });
  if (next == kTargets.end() || least > kLikely * *next) return runs;
  for (h = kShortest / 2; h > 1.01 * kShortestOfAll && least > *next; h /= 2) runWith(h);
  if (least > *next) runWith(kShortestOfAll);
  return runs;
}

}  // namespace rigid_body_sim::peers
