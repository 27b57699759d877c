#pragma once

#include <optional>
#include <string>

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

/// [s] since the origin: when the last message of a bag was recorded. Nothing where that does not
/// show how long the run of its inputs was: the bag holds inputs alone, or several runs one after
/// the other on one clock. Throws std::runtime_error with one line, the path first.
std::optional<double> recordEnd(const std::string& path, const TimeOrigin& origin);

}  // namespace rigid_body_sim
