#include "programs/tool_scene.hpp"

#include <rigid_body_sim/scene/load_scene.hpp>

#include "programs/package_directory.hpp"

namespace rigid_body_sim {

Scene loadToolScene(const std::string& path) { return loadScene(path, packageDirectory); }

std::string noticeLine(const std::string& program, const std::string& text) {
  return program + ": notice: " + text;
}

}  // namespace rigid_body_sim
