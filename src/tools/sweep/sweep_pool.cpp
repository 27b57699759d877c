#include "tools/sweep/sweep_pool.hpp"

#include <algorithm>
#include <chrono>
#include <string_view>
#include <thread>
#include <utility>

namespace rigid_body_sim {
namespace {

std::string_view withoutEnd(const std::string& line) {
  return std::string_view(line).substr(0, line.size() - 1);
}

}  // namespace

std::int64_t SweepPool::run(std::int64_t first, std::int64_t end,
                            const std::function<void(std::int64_t written)>& progress) {
  next_ = next_written_ = first;
  end_ = end;
  working_ = runners_.size();
  std::vector<std::thread> threads;
  for (const auto& runner : runners_) threads.emplace_back([&] { work(*runner); });
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (working_ > 0) {
      changed_.wait_for(lock, std::chrono::milliseconds(100));
      if (failure_) continue;
      try {
        progress(written_);
      } catch (...) {
        failure_ = std::current_exception();
      }
    }
  }
  for (std::thread& thread : threads) thread.join();
  if (failure_) std::rethrow_exception(failure_);
  return written_;
}

void SweepPool::work(SweepRunner& runner) {
  using Clock = std::chrono::steady_clock;
  constexpr std::int64_t kLargest = 4096;
  constexpr auto kLength = std::chrono::milliseconds(20);
  std::int64_t size = 1;
  try {
    for (Block block; take(size, block); block = {}) {
      const auto begin = Clock::now();
      make(runner, block);
      const bool quick = Clock::now() - begin < kLength;
      size = quick ? std::min(2 * size, kLargest) : std::max<std::int64_t>(1, size / 2);
      handOn(std::move(block));
    }
  } catch (...) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  --working_;
  changed_.notify_all();
}

/// The next runs; false where there are none. Waits while much is finished that one before holds
/// up: what is held up must not fill the memory.
bool SweepPool::take(std::int64_t size, Block& block) {
  constexpr std::size_t kMaxBytes = 64 << 20;
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [&] { return waiting_bytes_ < kMaxBytes || failure_ || stop_; });
  if (failure_ || stop_ || next_ >= end_) return false;
  block.first = next_;
  block.end = next_ = std::min(next_ + size, end_);
  return true;
}

void SweepPool::make(SweepRunner& runner, Block& block) const {
  for (std::int64_t j = block.first; j < block.end; ++j) {
    if (stop_) {
      block.end = j;
      return;
    }
    const RunRows rows = runner.run(shard_.run(j));
    MadeRuns& made = block.made;
    made.rows += rows.row;
    made.fan += rows.fan;
    ++made.ledger.rows;
    made.ledger.digest += digestOfRow(withoutEnd(rows.row));
    if (!rows.fan.empty()) made.ledger.fan_digest += digestOfRow(withoutEnd(rows.fan));
    if (!rows.doubt.empty()) made.ledger.addDoubt(shard_.run(j), rows.doubt);
    if (!rows.refusal.empty()) made.ledger.refused.add(shard_.run(j), rows.refusal);
  }
}

void SweepPool::handOn(Block block) {
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_bytes_ += block.made.rows.size() + block.made.fan.size();
  const std::int64_t first = block.first;
  finished_.emplace(first, std::move(block));
  for (auto next = finished_.begin();
       next != finished_.end() && next->first == next_written_ && !failure_;
       next = finished_.erase(next)) {
    const auto& [begin, end, made] = next->second;
    try {
      write_(made);
    } catch (...) {
      // before another thread has the lock: it would write the same rows again
      failure_ = std::current_exception();
      break;
    }
    next_written_ = end;
    written_ += end - begin;
    waiting_bytes_ -= made.rows.size() + made.fan.size();
  }
  changed_.notify_all();
}

}  // namespace rigid_body_sim
