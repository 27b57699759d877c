#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/urdf/read_urdf.hpp"

namespace rigid_body_sim {

/// What many bodies may give rise to: reported once, with the number of the others.
struct RepeatedNotice {
  std::string first;
  std::size_t count = 0;
};

/// What the reading of one scene has in common.
struct ReadContext {
  std::string source;               ///< the scene file, for messages
  std::filesystem::path directory;  ///< that relative paths start from; empty: the working one
  PackageFinder find_package;       ///< may be empty

  std::string world_frame = Scene().world_frame;
  std::vector<std::string> notices;
  std::set<std::string> files;  ///< see Scene
  using MeshKey = std::tuple<std::string, std::array<double, 3>, MeshSolid>;
  std::map<MeshKey, MeshDef> meshes;       ///< by path, scale and solid: each read once
  std::map<MeshKey, HullCorners> corners;  ///< likewise
  bool has_contact = false;                ///< whether the scene names contact
  RepeatedNotice fast_spin, flipped;
  std::map<std::string, UrdfRobot> robots;  ///< by path: each read once
};

}  // namespace rigid_body_sim
