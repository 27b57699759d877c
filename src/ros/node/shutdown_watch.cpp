#include "ros/node/shutdown_watch.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <ros/init.h>

#include "programs/usage.hpp"

namespace rigid_body_sim {

ShutdownWatch::ShutdownWatch()
    : thread_(std::chrono::milliseconds(100), [this] { return look(); }) {}

bool ShutdownWatch::look() {
  constexpr int kBegunLooks = 100;  // roscpp takes thousands of topics back one by one
  constexpr int kDoneLooks = 5;     // a node that computes nothing has ended by then
  begun_ += ros::isShuttingDown() ? 1 : 0;
  done_ += ros::ok() ? 0 : 1;
  if (begun_ < kBegunLooks && done_ < kDoneLooks) return true;
  std::fflush(stdout);
  std::_Exit(kDone);
}

}  // namespace rigid_body_sim
