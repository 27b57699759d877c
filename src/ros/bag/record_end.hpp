#pragma once

#include <optional>
#include <string>

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

/// [s] since the origin: the latest instant of the run of which a message in the bag tells, by its
/// stamp. Nothing where that does not show how long the run of its inputs was: the bag holds inputs
/// alone, or several runs one after the other on one clock. Throws std::runtime_error with one
/// line, the path first.
std::optional<double> recordEnd(const std::string& path, const TimeOrigin& origin);

}  // namespace rigid_body_sim
