#pragma once

#include <chrono>

namespace rigid_body_sim {

/// Lets a warning through once a second of wall time: ROS time, by which ROS_WARN_THROTTLE goes,
/// stands while a simulation that publishes it is paused.
class Seldom {
 public:
  bool isDue() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return false;
    next_ = now + std::chrono::seconds(1);
    return true;
  }

 private:
  std::chrono::steady_clock::time_point next_;
};

}  // namespace rigid_body_sim
