#pragma once

#include <string>

#include <visualization_msgs/Marker.h>

#include <rigid_body_sim/LawForces.h>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/snapshot.hpp"

/// Springs and tethers as messages and as lines in rviz.
namespace rigid_body_sim {

/// What all of them exert.
LawForces toLawForces(const Snapshot& snapshot, const std::string& world_frame,
                      const ros::Time& stamp);

/// A line between the ends, in the world frame, in the namespace law/spring or law/tether; by its
/// colour it pulls, pushes, or is slack. Its width is a share of the smaller body at its ends.
visualization_msgs::Marker lineMarker(const LineForce& line, const World& world);

}  // namespace rigid_body_sim
