#include "programs/looking_thread.hpp"

#include <utility>

namespace rigid_body_sim {

LookingThread::LookingThread(std::chrono::duration<double> pause, std::function<bool()> look)
    : thread_([this, pause, looks = std::move(look)] { run(pause, looks); }) {}

LookingThread::~LookingThread() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void LookingThread::run(std::chrono::duration<double> pause, const std::function<bool()>& look) {
  std::unique_lock<std::mutex> lock(mutex_);
  do {
    if (changed_.wait_for(lock, pause, [this] { return ends_; })) return;
  } while (look());
}

}  // namespace rigid_body_sim
