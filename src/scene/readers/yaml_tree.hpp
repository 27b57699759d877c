#pragma once

#include <string>
#include <vector>

#include "scene/message_text.hpp"

namespace rigid_body_sim {

/// A YAML document as a tree that keeps what messages and strictness need and yaml-cpp's own nodes
/// lose: the line of empty values, whether a scalar was quoted.
struct YamlNode {
  enum class Kind { kEmpty, kScalar, kList, kMapping };
  Kind kind = Kind::kEmpty;
  std::string key;   ///< in its mapping
  std::string text;  ///< of a scalar
  bool quoted = false;
  int line = 0;  ///< where its key, or else the value itself, begins; the first is 1
  std::vector<YamlNode> children;

  /// Null where a mapping lacks the key.
  const YamlNode* find(const std::string& name) const;
};

/// Throws SceneError for text that is not one YAML document, and for what a scene has no use for:
/// repeated keys, keys that are not scalars, anchors, aliases, tags, more than limits.hpp allows.
YamlNode parseYaml(const std::string& yaml_text, const std::string& source_name);

/// The value as a message shows it: on one line, flow style, shortened to about 60 characters.
std::string printable(const YamlNode& node);

}  // namespace rigid_body_sim
