#include "ros/bag/run_starts.hpp"

namespace rigid_body_sim {

bool RunStarts::isStart(const std::string& topic, const ros::Time& stamp) {
  const auto [known, is_new_topic] = last_.emplace(topic, stamp);
  const bool goes_back = !is_new_topic && stamp < known->second;
  known->second = stamp;
  const bool is_first_of_run = of_this_run_.insert(topic).second;
  if (!goes_back || is_first_of_run) return false;
  of_this_run_ = {topic};
  ++runs_;
  return true;
}

}  // namespace rigid_body_sim
