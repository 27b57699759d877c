#pragma once

#include <string>

#include <geometry_msgs/WrenchStamped.h>

#include <rigid_body_sim/AppliedWrench.h>

#include "ros/inputs/wrench_request.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

/// The slot of an id of AppliedWrench on its body; empty for none. No <body>/wrench has it.
std::string slotOfId(const std::string& id);

/// The request of a message on <body>/wrench: one slot for each frame, at the next step, held.
WrenchRequest toRequest(const std::string& body, const geometry_msgs::WrenchStamped& message);

/// The request of a message on `wrench`: one slot for each id; start as ROS time, zero: next step.
WrenchRequest toRequest(const AppliedWrench& message, const TimeOrigin& origin);

}  // namespace rigid_body_sim
