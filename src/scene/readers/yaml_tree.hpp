#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/message_text.hpp"
#include "scene/readers/block_store.hpp"

namespace rigid_body_sim {

/// Nodes that lie one after the other. Node: YamlNode, const or not.
template <class Node>
class YamlNodes {
 public:
  YamlNodes(Node* first, std::size_t size) : first_(first), size_(size) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Node* begin() const { return first_; }
  Node* end() const { return first_ + size_; }
  Node& front() const { return *first_; }
  Node& operator[](std::size_t i) const { return first_[i]; }

 private:
  Node* first_;
  std::size_t size_;
};

/// A YAML value with what messages and strict reading need: its line, and whether it was quoted.
/// It refers to texts and nodes of its document. A scene of many bodies has millions: 32 bytes.
class YamlNode {
 public:
  enum class Kind : std::uint8_t { kEmpty, kScalar, kList, kMapping };

  Kind kind() const { return kind_; }
  bool quoted() const { return quoted_; }

  /// Where its key, or else the value itself, begins; the first is 1.
  int line() const { return line_; }

  /// In its mapping.
  std::string_view key() const { return {key_, key_size_}; }

  /// Of a scalar; a zero byte follows it. Of others empty.
  std::string_view text() const {
    return kind_ == Kind::kScalar ? std::string_view(text_, size_) : std::string_view();
  }

  /// Of a list or mapping; none of others.
  YamlNodes<const YamlNode> children() const { return {first(), first() ? size_ : 0}; }
  YamlNodes<YamlNode> children() { return {first(), first() ? size_ : 0}; }

  /// Null where a mapping lacks the key.
  const YamlNode* find(std::string_view name) const;

  void setPlace(std::string_view key, int line);
  void setScalar(std::string_view text, bool quoted);
  void setChildren(Kind list_or_mapping, YamlNodes<YamlNode> children);

 private:
  YamlNode* first() const { return kind_ >= Kind::kList ? first_ : nullptr; }

  const char* key_ = "";
  union {
    const char* text_ = "";  // of a scalar
    YamlNode* first_;        // of the children of a list or mapping
  };
  std::uint32_t size_ = 0;  // of the text, or number of children
  int line_ = 0;
  std::uint16_t key_size_ = 0;
  Kind kind_ = Kind::kEmpty;
  bool quoted_ = false;
};

/// A YAML document. Its nodes refer to its texts: it may be moved, not copied.
struct YamlDocument {
  YamlDocument() = default;
  YamlDocument(YamlDocument&&) = default;
  YamlDocument& operator=(YamlDocument&&) = default;

  /// A copy of the text that lasts as long as the document; a zero byte follows it.
  std::string_view keep(std::string_view text);

  /// Room for nodes that lasts as long as the document.
  YamlNodes<YamlNode> makeNodes(std::size_t count) { return {nodes.make(count), count}; }

  YamlNode root;
  BlockStore<char> texts;
  BlockStore<YamlNode> nodes;
};

/// Throws SceneError for text that is not one YAML document, and for what a scene has no use for:
/// repeated keys, keys that are not scalars, anchors, aliases, tags, more than limits.hpp allows.
YamlDocument parseYaml(const std::string& yaml_text, const std::string& source_name);

/// The value as a message shows it: on one line, flow style, shortened to about 60 characters.
std::string printable(const YamlNode& node);

}  // namespace rigid_body_sim
