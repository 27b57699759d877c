#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/readers/yaml_tree.hpp"

namespace rigid_body_sim {

/// A step of a path into a scene file: a key or a name, or the number of a list's item.
struct PathStep {
  std::string name;
  std::optional<std::size_t> item;
};

/// The steps of a path such as bodies.box.twist.angular[2]; empty where it is none.
std::vector<PathStep> stepsOf(const std::string& path);

/// The node that a step leads to: a key of a mapping; of a list, an item by its number or by the
/// value of its key `name`. Null where there is none.
YamlNode* follow(YamlNode& node, const PathStep& step);

/// The node at a path; null where there is none.
YamlNode* nodeAt(YamlNode& root, const std::string& path);

/// The paths of the tree, down to the single values: the first kMaxComparedNames or so.
std::vector<std::string> pathsOf(const YamlNode& root);

}  // namespace rigid_body_sim
