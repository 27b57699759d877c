#pragma once

#include <string>
#include <vector>

#include <tinyxml2.h>

namespace rigid_body_sim {

/// Removes the <material> elements of a robot whose colour is not four numbers from 0 to 1, which
/// urdfdom refuses or takes for black, and those that define a name for the second time. Returns a
/// notice for each.
std::vector<std::string> dropBadMaterials(tinyxml2::XMLDocument& document);

/// Removes what is drawn and what is touched: <visual> and <collision> of every link, and the
/// materials of the robot.
void dropVisuals(tinyxml2::XMLDocument& document);

}  // namespace rigid_body_sim
