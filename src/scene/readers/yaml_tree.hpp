#pragma once

#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "scene/message_text.hpp"

namespace rigid_body_sim {

/// A YAML value with what messages and strict reading need: its line, and whether it was quoted.
struct YamlNode {
  enum class Kind { kEmpty, kScalar, kList, kMapping };
  std::string_view key;   ///< in its mapping
  std::string_view text;  ///< of a scalar; a zero byte follows it
  std::vector<YamlNode> children;
  int line = 0;  ///< where its key, or else the value itself, begins; the first is 1
  Kind kind = Kind::kEmpty;
  bool quoted = false;

  /// Null where a mapping lacks the key.
  const YamlNode* find(std::string_view name) const;
};

/// Texts that stay where they are, each followed by a zero byte.
class TextStore {
 public:
  std::string_view add(std::string_view text);

 private:
  std::list<std::string> blocks_;
};

/// A YAML document. Its nodes refer to its texts: it may be moved, not copied.
struct YamlDocument {
  YamlDocument() = default;
  YamlDocument(YamlDocument&&) = default;
  YamlDocument& operator=(YamlDocument&&) = default;

  YamlNode root;
  TextStore texts;
};

/// Throws SceneError for text that is not one YAML document, and for what a scene has no use for:
/// repeated keys, keys that are not scalars, anchors, aliases, tags, more than limits.hpp allows.
YamlDocument parseYaml(const std::string& yaml_text, const std::string& source_name);

/// The value as a message shows it: on one line, flow style, shortened to about 60 characters.
std::string printable(const YamlNode& node);

}  // namespace rigid_body_sim
