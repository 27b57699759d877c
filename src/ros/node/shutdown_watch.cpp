#include "ros/node/shutdown_watch.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <ros/init.h>

#include "programs/usage.hpp"

namespace rigid_body_sim {

ShutdownWatch::~ShutdownWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void ShutdownWatch::watch() {
  constexpr std::chrono::milliseconds kPause(100);
  constexpr int kBegunLooks = 100;  // roscpp takes thousands of topics back one by one
  constexpr int kDoneLooks = 5;     // a node that computes nothing has ended by then
  std::unique_lock<std::mutex> lock(mutex_);
  int begun = 0, done = 0;  // looks at which roscpp's shutdown was
  while (begun < kBegunLooks && done < kDoneLooks) {
    if (changed_.wait_for(lock, kPause, [this] { return ends_; })) return;
    begun += ros::isShuttingDown() ? 1 : 0;
    done += ros::ok() ? 0 : 1;
  }
  std::fflush(stdout);
  std::_Exit(kDone);
}

}  // namespace rigid_body_sim
