#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace rigid_body_sim {

/// Looks at something again and again, from a thread of its own, until it has seen enough or this
/// object ends.
class LookingThread {
 public:
  /// look() returns whether to look again, after a pause as before it. What it looks at must
  /// outlive this.
  LookingThread(std::chrono::duration<double> pause, std::function<bool()> look);
  ~LookingThread();
  LookingThread(const LookingThread&) = delete;
  LookingThread& operator=(const LookingThread&) = delete;

 private:
  void run(std::chrono::duration<double> pause, const std::function<bool()>& look);

  std::mutex mutex_;
  std::condition_variable changed_;
  bool ends_ = false;
  std::thread thread_;  // the last: it sees the others
};

}  // namespace rigid_body_sim
