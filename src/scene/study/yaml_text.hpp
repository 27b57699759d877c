#pragma once

#include <filesystem>
#include <string>

#include "scene/readers/yaml_tree.hpp"

namespace rigid_body_sim {

/// The tree as YAML: a line for each key of the root and each item of its lists. Files that are
/// named relative to the directory get absolute paths.
std::string yamlText(const YamlNode& root, const std::filesystem::path& directory);

}  // namespace rigid_body_sim
