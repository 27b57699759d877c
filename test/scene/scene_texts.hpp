#pragma once

#include <string>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

namespace rigid_body_sim {

/// A scene of one body "box", complete in five lines; more lines of its entry follow from line 6.
inline std::string boxScene(const std::string& more = "") {
  return "time_step: 0.01\nbodies:\n  - name: box\n    shape: {box: [1, 1, 1]}\n    mass: 1\n" +
         more;
}

/// What loading and building say against a text, "" when nothing.
inline std::string errorOf(const std::string& text) {
  try {
    buildWorld(parseScene(text, "s.yaml"));
  } catch (const SceneError& e) {
    return e.what();
  }
  return "";
}

inline std::string boxError(const std::string& more) { return errorOf(boxScene(more)); }

/// Where the errors of boxScene's further lines are said to be.
inline const std::string kAtBox = "s.yaml:6: body 'box': ";

}  // namespace rigid_body_sim
