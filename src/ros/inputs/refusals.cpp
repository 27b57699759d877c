#include "ros/inputs/refusals.hpp"

#include <ros/console.h>

namespace rigid_body_sim {

void Refusals::add(const char* what, const std::string& reason) {
  ++count_;
  if (!warning_.isDue()) return;
  ROS_WARN("%s refused (%lld so far): %s", what, static_cast<long long>(count_), reason.c_str());
}

}  // namespace rigid_body_sim
