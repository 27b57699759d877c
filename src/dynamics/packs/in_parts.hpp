#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace rigid_body_sim {

/// How many threads so much work is worth: a thread costs some 20 us to start, for which each is to
/// have ten times as much to do. least: the work of 200 us.
inline std::size_t worthwhileThreads(int most, std::size_t work, std::size_t least) {
  return std::max<std::size_t>(1, std::min(work / least, static_cast<std::size_t>(most)));
}

/// As inParts, with more than one thread.
void inThreads(std::size_t items, std::size_t unit, std::size_t threads,
               const std::function<void(std::size_t first, std::size_t end)>& part);

/// Calls part(first, end) for consecutive ranges that make up [0, items), whose bounds but the last
/// are multiples of `unit`, each on a thread of its own, one of them the caller's. Returns when all
/// are done; throws what the first of them in order threw. Where the system gives no more threads,
/// the caller's does what is left.
template <class Part>
void inParts(std::size_t items, std::size_t unit, std::size_t threads, const Part& part) {
  const std::size_t most = std::min(threads, (items + unit - 1) / unit);
  if (most <= 1) return part(std::size_t{0}, items);
  inThreads(items, unit, most, part);
}

}  // namespace rigid_body_sim
