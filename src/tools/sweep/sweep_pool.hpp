#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tools/sweep/shard.hpp"
#include "tools/sweep/sweep_ledger.hpp"
#include "tools/sweep/sweep_runner.hpp"

namespace rigid_body_sim {

/// Runs that one thread has made, one after the other.
struct MadeRuns {
  std::string rows, fan;  ///< of runs.csv and of fan.csv
  SweepLedger ledger{};   ///< of these rows
};

/// Makes runs on several threads, and hands their rows on in the order of the runs.
class SweepPool {
 public:
  /// Takes runs in their order, one call at a time.
  using Write = std::function<void(const MadeRuns& made)>;

  /// One thread for each runner. stop: once true, no further run is begun. progress:
  /// is told from time to time how many runs are written, while nothing is.
  SweepPool(std::vector<std::unique_ptr<SweepRunner>>& runners, Shard shard, Write write,
            const std::atomic<bool>& stop)
      : runners_(runners), shard_(shard), write_(std::move(write)), stop_(stop) {}

  /// The runs first … end − 1 of the shard; returns how many are written. progress: is told so
  /// from time to time, while nothing is written. Throws what a run, a write or
  /// progress throws.
  std::int64_t run(std::int64_t first, std::int64_t end,
                   const std::function<void(std::int64_t written)>& progress);

 private:
  /// Runs that one thread makes before it hands them on.
  struct Block {
    std::int64_t first = 0, end = 0;
    MadeRuns made;
  };

  void work(SweepRunner& runner);
  bool take(std::int64_t size, Block& block);
  void make(SweepRunner& runner, Block& block) const;
  void handOn(Block block);

  std::vector<std::unique_ptr<SweepRunner>>& runners_;
  Shard shard_;
  Write write_;
  const std::atomic<bool>& stop_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::int64_t next_ = 0, end_ = 0;         // to be taken
  std::int64_t next_written_ = 0;           // of the shard
  std::map<std::int64_t, Block> finished_;  // that wait for those before them
  std::size_t waiting_bytes_ = 0;
  std::size_t working_ = 0;  // threads
  std::int64_t written_ = 0;
  std::exception_ptr failure_;
};

}  // namespace rigid_body_sim
