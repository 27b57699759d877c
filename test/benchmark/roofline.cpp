#include <cstdio>
#include <vector>

#include "math/pack.hpp"
#include "tools/trade/cpu_time.hpp"

// What this machine can do at most: additions and multiplications of doubles in a second of one
// core, at the width of the baseline and of AVX2, not contracted; and bytes that one core moves to
// and from memory. doc/performance.md sets what packs reach beside it.

namespace rigid_body_sim {
namespace {

// That do not wait for one another: enough to hide latency, and so few that sums, products and the
// two constants stay in sixteen registers. With eight a third of the limit was measured.
constexpr int kChains = 6;

/// Half of them additions, half of them multiplications.
template <class T>
RIGID_BODY_SIM_INLINE void operate(long times, double* numbers) {
  constexpr int kLanes = sizeof(T) / sizeof(double);
  T sums[kChains], products[kChains];
  for (int c = 0; c < kChains; ++c) {
    load(numbers + c * kLanes, sums[c]);
    products[c] = sums[c];
  }
  const T term = 1e-9, factor = 1.0 + 1e-12;
  for (long k = 0; k < times; ++k)
    for (int c = 0; c < kChains; ++c) {
      sums[c] = sums[c] + term;
      products[c] = products[c] * factor;
    }
  for (int c = 0; c < kChains; ++c) store(sums[c] + products[c], numbers + c * kLanes);
}

void operateNarrow(long times, double* numbers) { operate<Pack<2>>(times, numbers); }

#if defined(__x86_64__)
__attribute__((target("avx2"))) void operateWide(long times, double* numbers) {
  operate<Pack<4>>(times, numbers);
}
#endif

template <class Action>
double leastSeconds(const Action& action) {
  double least = 1e9;
  for (int run = 0; run < 10; ++run) {
    const double begin = cpuTime();
    action();
    least = std::min(least, cpuTime() - begin);
  }
  return least;
}

void printOperations(const char* name, int lanes, void (*operations)(long, double*)) {
  constexpr long kTimes = 10000000;
  std::vector<double> numbers(64, 1.0);
  const double seconds = leastSeconds([&] { operations(kTimes, numbers.data()); });
  std::printf("%-34s %8.1f 1e9/s\n", name,
              1e-9 * 2.0 * kChains * lanes * static_cast<double>(kTimes) / seconds);
}

void printBandwidth() {
  std::vector<double> numbers(std::size_t{1} << 27, 1.0);  // 1 GiB
  const double seconds = leastSeconds([&] {
    for (double& number : numbers) number = number + 1e-9;
  });
  std::printf("%-34s %8.1f GB/s\n", "read and written, from memory",
              1e-9 * 2.0 * static_cast<double>(numbers.size() * sizeof(double)) / seconds);
}

}  // namespace
}  // namespace rigid_body_sim

int main() {
  using namespace rigid_body_sim;
  printOperations("operations, two lanes", 2, operateNarrow);
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) printOperations("operations, AVX2", 4, operateWide);
#endif
  printBandwidth();
}
