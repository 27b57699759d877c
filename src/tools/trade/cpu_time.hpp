#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <limits>
#include <vector>

namespace rigid_body_sim {

/// [s] of processor time that this program has used: what other programs take does not count.
inline double cpuTime() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// [s] of processor time of one run, the least of several, as disturbances only ever add. Each run
/// gets a fresh copy of the start; the copy is not timed. A run too short for the clock is made of
/// several copies. budget [s]: where the repeating ends; at least two runs are made, of which the
/// first warms up.
template <class Start, class Run>
double leastCpuTime(const Start& start, const Run& run, double budget) {
  constexpr double kShortest = 20e-6;  // [s] some hundred times what reading the clock takes
  constexpr int kMaxRuns = 200;
  const auto timed = [&](int copies) {
    std::vector<Start> fresh(static_cast<std::size_t>(copies), start);
    const double begin = cpuTime();
    for (Start& each : fresh) run(each);
    return (cpuTime() - begin) / copies;
  };
  const double begin = cpuTime();
  const double first = timed(1);
  const int copies = static_cast<int>(std::clamp(kShortest / std::max(first, 1e-9), 1.0, 100.0));
  double least = std::numeric_limits<double>::infinity();
  for (int runs = 0; runs < kMaxRuns; ++runs) {
    least = std::min(least, timed(copies));
    if (cpuTime() - begin > budget) break;
  }
  return least;
}

}  // namespace rigid_body_sim
