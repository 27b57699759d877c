#pragma once

#include <functional>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "ros/inputs/wrench_request.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

/// The subscriptions and services that let wrenches in and end them: <body>/wrench of every body
/// given, ~wrench, ~apply_wrench and ~clear_wrenches. Each message goes to the sink, in order of
/// arrival, from whoever serves the queue of the handles.
class WrenchDoors {
 public:
  /// Takes a request, or returns its fault, one line.
  using Sink = std::function<std::string(const WrenchRequest&)>;

  struct Cleared {
    std::string fault;  ///< one line; empty if none
    std::size_t count = 0;
  };
  /// Ends the wrenches of a body, empty: of all; those of one slot, empty: of every slot.
  using Clear = std::function<Cleared(const std::string& body, const std::string& slot)>;

  WrenchDoors(ros::NodeHandle nh, ros::NodeHandle private_nh,
              const std::vector<std::string>& bodies, const TimeOrigin& origin, const Sink& sink,
              const Clear& clear);

 private:
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace rigid_body_sim
