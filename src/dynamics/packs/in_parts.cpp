#include "dynamics/packs/in_parts.hpp"

#include <algorithm>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace rigid_body_sim {

void inParts(std::size_t items, std::size_t unit, std::size_t threads,
             const std::function<void(std::size_t first, std::size_t end)>& part) {
  const std::size_t units = (items + unit - 1) / unit;
  threads = std::max<std::size_t>(1, std::min(threads, units));
  if (threads == 1) return part(0, items);
  std::vector<std::exception_ptr> thrown(threads);
  const auto run = [&](std::size_t k) {
    const auto bound = [&](std::size_t i) { return std::min(items, i * units / threads * unit); };
    try {
      part(bound(k), k + 1 == threads ? items : bound(k + 1));
    } catch (...) {
      thrown[k] = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  others.reserve(threads);
  std::size_t begun = 1;
  try {
    for (; begun < threads; ++begun) others.emplace_back(run, begun);
  } catch (const std::system_error&) {
    // no more threads to be had
  }
  run(0);
  for (; begun < threads; ++begun) run(begun);
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& each : thrown)
    if (each) std::rethrow_exception(each);
}

}  // namespace rigid_body_sim
