#pragma once

#include <cstddef>
#include <functional>

namespace rigid_body_sim {

/// How many threads so much work is worth: a thread costs some 20 us to start, for which each is to
/// have ten times as much to do. least: the work of 200 us.
inline std::size_t worthwhileThreads(int most, std::size_t work, std::size_t least) {
  const std::size_t worth = work / least;
  return worth < 1                                ? 1
         : worth < static_cast<std::size_t>(most) ? worth
                                                  : static_cast<std::size_t>(most);
}

/// Calls part(first, end) for consecutive ranges that make up [0, items), whose bounds but the last
/// are multiples of `unit`, each on a thread of its own, one of them the caller's. Returns when all
/// are done; throws what the first of them in order threw. Where the system gives no more threads,
/// the caller's does what is left.
void inParts(std::size_t items, std::size_t unit, std::size_t threads,
             const std::function<void(std::size_t first, std::size_t end)>& part);

}  // namespace rigid_body_sim
