#pragma once

#include <ros/time.h>

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

/// [s] When input with this stamp acts, in simulation time: now, where the stamp is zero or past.
/// Throws std::invalid_argument, which names the field, for a stamp more than `farthest` [s] ahead:
/// one of another clock, such as wall time, whose input would wait for ever, in silence.
double startOfInput(const char* field, const ros::Time& stamp, const TimeOrigin& origin, double now,
                    double farthest);

}  // namespace rigid_body_sim
