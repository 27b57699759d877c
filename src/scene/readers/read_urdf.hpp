#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/scene/visual.hpp>

namespace rigid_body_sim {

/// What a URDF file says of one link, in the link's frame.
struct UrdfLink {
  std::string name;
  std::optional<MassProperties> mass;  ///< of <inertial>; none without that element
  std::vector<Visual> visuals;         ///< of every <visual>
};

/// The links of a URDF file, sorted by name. The inertia of <inertial> is about the centre of mass
/// in the axes of its <origin>, I_B = R(rpy) I R(rpy)ᵀ; it is not checked here. Relative names of
/// mesh files start from the directory of the URDF file.
///
/// Not for two threads at once: while it reads, it takes the output of console_bridge, which is one
/// for the whole process, and gives it back however the reading ends.
///
/// Throws std::runtime_error with one line, the path first, for a file that cannot be read, is
/// larger than 16 MiB, or is no URDF robot.
std::vector<UrdfLink> readUrdf(const std::string& path);

}  // namespace rigid_body_sim
