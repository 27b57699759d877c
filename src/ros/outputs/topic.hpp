#pragma once

#include <cstddef>
#include <functional>

#include <ros/time.h>

namespace rigid_body_sim {

/// A topic to write to, whatever lies behind it: a publisher of ROS or a bag.
template <class Message>
struct Topic {
  std::function<std::size_t()> heard;  ///< how many take what is published
  std::function<void(const Message&, const ros::Time& stamp)> publish;
};

}  // namespace rigid_body_sim
