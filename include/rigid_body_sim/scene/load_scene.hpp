#pragma once

#include <string>

#include <rigid_body_sim/scene/scene.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {

/// Reads a scene file (YAML, one document, at most 16 MiB, without anchors and aliases, so that its
/// size bounds what it describes). Every number becomes the nearest double, whatever the locale.
/// An unknown, missing or repeated key and every value that breaks its rule throws SceneError;
/// nothing bad is ever replaced by a default.
Scene loadScene(const std::string& path);

/// The same from the text itself; source_name stands for the file in messages.
Scene parseScene(const std::string& yaml_text, const std::string& source_name);

}  // namespace rigid_body_sim
