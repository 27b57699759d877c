#pragma once

#include <string>
#include <vector>

#include <urdf_model/model.h>
#include <urdf_world/types.h>

namespace rigid_body_sim {

struct ParsedUrdf {
  urdf::ModelInterfaceSharedPtr model;
  std::vector<std::string> notices;  ///< what was left out of what is drawn, and why
  std::string
      looks_fault;  ///< what is wrong with <visual> and <collision> elements; empty: nothing
};

/// Parses the XML of a robot, without what of its looks cannot be read. Throws std::runtime_error
/// with the reason.
ParsedUrdf parseUrdf(const std::string& xml);

}  // namespace rigid_body_sim
