#include "ros/inputs/refusals.hpp"

#include <ros/console.h>

namespace rigid_body_sim {

void Refusals::add(const char* what, const std::string& reason) {
  ++count_;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_warning_) return;
  next_warning_ = now + std::chrono::seconds(1);
  ROS_WARN("%s refused (%lld so far): %s", what, static_cast<long long>(count_), reason.c_str());
}

}  // namespace rigid_body_sim
