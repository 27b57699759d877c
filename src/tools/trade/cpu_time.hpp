#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <utility>
#include <vector>

namespace rigid_body_sim {

/// [s] of processor time that this program has used: what other programs take does not count.
inline double cpuTime() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least of some times of the same work, as disturbances add, but for their lowest tenth: in a
/// virtual machine the clock of cpuTime counts too little once in some thousand times, by some 10
/// µs, where it makes up for what the host took before. The least of all would be such a one.
inline double undisturbed(std::vector<double> times) {
  const auto chosen = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 10);
  std::nth_element(times.begin(), chosen, times.end());
  return *chosen;
}

/// [s] of processor time of one undisturbed run of several. Each run gets a fresh copy of the
/// start; the copy is not timed. A run too short for the clock is made of several copies. budget
/// [s]: where the repeating ends; at least two runs are made, of which the first warms up.
template <class Start, class Run>
double undisturbedCpuTime(const Start& start, const Run& run, double budget) {
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
  std::vector<double> times;
  for (int runs = 0; runs < kMaxRuns; ++runs) {
    times.push_back(timed(copies));
    if (cpuTime() - begin > budget) break;
  }
  return undisturbed(std::move(times));
}

}  // namespace rigid_body_sim
