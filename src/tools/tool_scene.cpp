#include "tool_scene.hpp"

#include <cstdio>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "package_directory.hpp"

namespace rigid_body_sim {

Scene loadToolScene(const std::string& path, const std::string& program) {
  Scene scene = loadScene(path, packageDirectory);
  for (const std::string& notice : scene.notices) printNotice(program, notice);
  return scene;
}

void printNotice(const std::string& program, const std::string& text) {
  std::fprintf(stderr, "%s: notice: %s\n", program.c_str(), text.c_str());
}

}  // namespace rigid_body_sim
