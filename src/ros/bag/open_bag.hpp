#pragma once

#include <string>

namespace rosbag {
class Bag;
}

namespace rigid_body_sim {

/// Opens a bag for reading. Throws std::runtime_error that says what to do about one that is cut.
void openBag(const std::string& path, rosbag::Bag& bag);

}  // namespace rigid_body_sim
