#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace rigid_body_sim {

/// Ends the process where a shutdown finds it computing: a step, or the trials of auto before the
/// first, may take minutes, and ask nobody. Nothing is lost by it: what is published then reaches
/// nobody, and no file is replaced before it is whole.
class ShutdownWatch {
 public:
  ShutdownWatch() : thread_([this] { watch(); }) {}
  ~ShutdownWatch();
  ShutdownWatch(const ShutdownWatch&) = delete;
  ShutdownWatch& operator=(const ShutdownWatch&) = delete;

 private:
  void watch();

  std::mutex mutex_;
  std::condition_variable changed_;
  bool ends_ = false;
  std::thread thread_;  // the last: it sees the others
};

}  // namespace rigid_body_sim
