#include "tools/sweep/sweep_ledger.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "math/counter_draws.hpp"

namespace rigid_body_sim {

void NotedRuns::add(std::int64_t run, const std::string& reason) {
  add(NotedRuns{1, run, reason, false});
}

void NotedRuns::add(const NotedRuns& more) {
  if (more.count > 0 && (count == 0 || more.first < first)) {
    first = more.first;
    why = more.why;
  }
  count += more.count;
  is_at_least |= more.is_at_least;
}

void SweepLedger::addDoubt(std::int64_t run, const std::string& reason) {
  doubtful.add(run, reason);
  if (doubtful_runs.size() < kMaxNamed) doubtful_runs.push_back(run);
}

void SweepLedger::addDoubtsBefore(std::int64_t end, const SweepLedger& all) {
  for (const std::int64_t run : all.doubtful_runs)
    if (run < end) addDoubt(run, run == all.doubtful.first ? all.doubtful.why : "");
  // beyond the last that is named there may be others
  const bool names_all = !all.doubtful.is_at_least &&
                         all.doubtful.count == static_cast<std::int64_t>(all.doubtful_runs.size());
  const bool names_beyond = !all.doubtful_runs.empty() && all.doubtful_runs.back() >= end;
  doubtful.is_at_least |= !names_all && !names_beyond;
}

void SweepLedger::add(const SweepLedger& more) {
  rows += more.rows;
  digest += more.digest;
  fan_digest += more.fan_digest;
  refused.add(more.refused);
  doubtful.add(more.doubtful);
  is_other |= more.is_other;
  if (more.doubtful_runs.empty()) return;
  std::vector<std::int64_t> all;
  std::merge(doubtful_runs.begin(), doubtful_runs.end(), more.doubtful_runs.begin(),
             more.doubtful_runs.end(), std::back_inserter(all));
  all.resize(std::min(all.size(), kMaxNamed));
  doubtful_runs = std::move(all);
}

/// As FNV-1a, but eight bytes at a time.
std::uint64_t digestOfRow(std::string_view row) {
  std::uint64_t hash = 0xCBF29CE484222325 + row.size();
  const auto add = [&](std::uint64_t word) {
    hash = (hash ^ word) * 0x100000001B3;
    hash ^= hash >> 32;
  };
  std::uint64_t word = 0;
  for (; row.size() >= sizeof word; row.remove_prefix(sizeof word)) {
    std::memcpy(&word, row.data(), sizeof word);
    add(word);
  }
  word = 0;
  std::memcpy(&word, row.data(), row.size());
  add(word);
  return mixBits(hash);
}

}  // namespace rigid_body_sim
