#pragma once

#include <string>

namespace rigid_body_sim {

/// The directory of a ROS package, "" for one that ROS does not know; a PackageFinder. As
/// ros::package::getPath, which says lines of its own on standard error when there is none.
std::string packageDirectory(const std::string& package);

}  // namespace rigid_body_sim
