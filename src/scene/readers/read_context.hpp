#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <rigid_body_sim/scene/load_scene.hpp>

namespace rigid_body_sim {

/// What the reading of one scene has in common.
struct ReadContext {
  std::string source;               ///< the scene file, for messages
  std::filesystem::path directory;  ///< that relative paths start from; empty: the working one
  PackageFinder find_package;       ///< may be empty

  std::vector<std::string> notices;
  using MeshKey = std::tuple<std::string, std::array<double, 3>, MeshSolid>;
  std::map<MeshKey, MeshDef> meshes;  ///< by path, scale and solid: each read once
};

}  // namespace rigid_body_sim
