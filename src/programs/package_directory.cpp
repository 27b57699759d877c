#include "programs/package_directory.hpp"

#include <algorithm>
#include <vector>

#include <ros/package.h>

namespace rigid_body_sim {

std::string packageDirectory(const std::string& package) {
  std::vector<std::string> known;
  ros::package::getAll(known);
  const bool is_known = std::find(known.begin(), known.end(), package) != known.end();
  return is_known ? ros::package::getPath(package) : "";
}

}  // namespace rigid_body_sim
