#pragma once

#include <functional>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "conversions.hpp"
#include "wrench_request.hpp"

namespace rigid_body_sim {

/// The subscriptions that let wrenches in: <body>/wrench of every body given, and ~wrench. Each
/// message goes to the sink, in order of arrival, from whoever serves the queue of the handles.
class WrenchDoors {
 public:
  using Sink = std::function<void(const WrenchRequest&)>;

  WrenchDoors(ros::NodeHandle nh, ros::NodeHandle private_nh,
              const std::vector<std::string>& bodies, const TimeOrigin& origin, const Sink& sink);

 private:
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace rigid_body_sim
