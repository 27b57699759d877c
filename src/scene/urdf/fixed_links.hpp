#pragma once

#include <string>
#include <vector>

#include "scene/urdf/read_urdf.hpp"

namespace rigid_body_sim {

/// A link L as part of a body whose frame B is that of another link.
struct PlacedLink {
  const UrdfLink* link;
  Isometry3d X_BL = Isometry3d::Identity();
};

/// A link of the robot and all that hangs on it by fixed joints, it first, each after its parent.
/// Empty where the robot has no such link.
std::vector<PlacedLink> fixedLinks(const UrdfRobot& robot, const std::string& base);

}  // namespace rigid_body_sim
