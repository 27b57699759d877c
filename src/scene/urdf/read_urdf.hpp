#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/scene/visual.hpp>

namespace rigid_body_sim {

/// A mesh file as a URDF file names it: package://, or a path from the directory of that file.
struct UrdfMesh {
  std::string file;
  Vector3d scale = Vector3d::Ones();
};

using UrdfGeometry = std::variant<Shape, UrdfMesh>;

/// A <collision> element; its numbers and files are not checked here.
struct UrdfCollision {
  std::optional<UrdfGeometry> geometry;      ///< none: of a kind that is not known here
  Isometry3d X_LC = Isometry3d::Identity();  ///< of the geometry, in the link
};

/// What a URDF file says of one link L, in the link's frame.
struct UrdfLink {
  std::string name;
  std::optional<MassProperties> mass;  ///< of <inertial>; none without that element
  std::vector<Visual> visuals;         ///< of every <visual>
  std::vector<UrdfCollision> collisions;

  std::string parent;                        ///< the link that its joint joins it to; empty: none
  bool fixed = false;                        ///< whether that joint is fixed
  Isometry3d X_PL = Isometry3d::Identity();  ///< pose in the frame of the parent
};

/// A URDF file. Its links form one tree.
struct UrdfRobot {
  std::string root;
  std::vector<UrdfLink> links;       ///< sorted by name
  std::vector<std::string> notices;  ///< what was left out of what is drawn, and why
  std::string collision_fault;       ///< why <collision> elements may be missing; empty: none is
};

/// Reads a URDF file. The inertia of <inertial> is about the centre of mass in the axes of its
/// <origin>, I_B = R(rpy) I R(rpy)ᵀ; it is not checked here. Relative names of mesh files start
/// from the directory of the URDF file. What is drawn has no part in the motion: a colour or a
/// <visual> that cannot be read is left out, with a notice.
///
/// Not for two threads at once: while it reads, it takes the output of console_bridge, which is one
/// for the whole process, and gives it back however the reading ends.
///
/// Throws std::runtime_error with one line, the path first, for a file that cannot be read, exceeds
/// limits.hpp, is no URDF robot, or whose links are no tree.
UrdfRobot readUrdf(const std::string& path);

/// A message about a link: "link 'arm': …".
std::string ofLink(const std::string& link, const std::string& text);

}  // namespace rigid_body_sim
