#pragma once

#include <rigid_body_sim/scene/scene.hpp>

#include "scene/readers/read_context.hpp"
#include "scene/readers/yaml_tree.hpp"

namespace rigid_body_sim {

/// The scene that a tree describes; see loadScene. Throws SceneError.
Scene readScene(const YamlNode& tree, ReadContext& context);

}  // namespace rigid_body_sim
