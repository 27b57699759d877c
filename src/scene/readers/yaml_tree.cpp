#include "scene/readers/yaml_tree.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/limits.hpp"
#include "scene/readers/yaml_events.hpp"

namespace rigid_body_sim {
namespace {

/// Builds the tree while the parser reads, so that excess is refused before it costs anything.
class TreeBuilder {
 public:
  explicit TreeBuilder(const std::string& source) : source_(source) {}

  void take(const YamlEvent& event) {
    switch (event.type) {
      case YAML_DOCUMENT_START_EVENT:
        if (++documents_ > 1) fail(event, "a second YAML document; a scene file holds one");
        return;
      case YAML_ALIAS_EVENT:
        failOnAnchor(event);
      case YAML_SCALAR_EVENT:
        return takeScalar(event);
      case YAML_SEQUENCE_START_EVENT:
        return open(add(YamlNode::Kind::kList, event), event);
      case YAML_MAPPING_START_EVENT:
        return open(add(YamlNode::Kind::kMapping, event), event);
      case YAML_SEQUENCE_END_EVENT:
      case YAML_MAPPING_END_EVENT:
        return open_.pop_back();
      default:
        return;  // starts and ends of the stream, ends of documents
    }
  }

  YamlDocument finish() {
    if (documents_ == 0) throw SceneError(source_, 0, "is empty; a scene is a YAML mapping");
    return std::move(document_);
  }

 private:
  /// A list or mapping whose end is still to come.
  struct Open {
    YamlNode* node;
    bool has_key = false;  ///< a key waits for its value
    std::string_view key;
    int key_line = 0;
    std::unordered_set<std::string_view> keys;  ///< of a mapping of many, else empty
  };

  [[noreturn]] void fail(const YamlEvent& event, const std::string& message) const {
    throw SceneError(source_, event.line, message);
  }
  [[noreturn]] void failOnAnchor(const YamlEvent& event) const {
    fail(event, "YAML anchors (&) and aliases (*) are not allowed in a scene");
  }

  bool expectsKey() const {
    return !open_.empty() && open_.back().node->kind == YamlNode::Kind::kMapping &&
           !open_.back().has_key;
  }

  void refuseDecorations(const YamlEvent& event) const {
    if (event.has_anchor) failOnAnchor(event);
    if (!event.tag.empty())
      fail(event, "YAML tags are not allowed in a scene, got " + printable(std::string(event.tag)));
  }

  void takeScalar(const YamlEvent& event) {
    if (event.text.size() > kMaxTextBytes)
      fail(event, "a text must have at most " + std::to_string(kMaxTextBytes) + " bytes, got " +
                      std::to_string(event.text.size()));
    if (expectsKey() && !event.isNull()) return takeKey(event);
    YamlNode& node = add(event.isNull() ? YamlNode::Kind::kEmpty : YamlNode::Kind::kScalar, event);
    if (event.isNull()) return;
    node.text = document_.texts.add(event.text);
    node.quoted = event.quoted;
  }

  void takeKey(const YamlEvent& event) {
    refuseDecorations(event);
    Open& mapping = open_.back();
    mapping.key = document_.texts.add(event.text);
    if (isRepeated(mapping))
      fail(event, "key '" + printable(std::string(event.text)) + "' is repeated");
    mapping.has_key = true;
    mapping.key_line = event.line;
  }

  /// Whether the mapping has its new key already. Few keys are compared one by one, many by a
  /// table.
  static bool isRepeated(Open& mapping) {
    constexpr std::size_t kFew = 32;
    const std::vector<YamlNode>& values = mapping.node->children;
    if (values.size() < kFew) return mapping.node->find(mapping.key) != nullptr;
    if (mapping.keys.empty())
      for (const YamlNode& value : values) mapping.keys.insert(value.key);
    return !mapping.keys.insert(mapping.key).second;
  }

  YamlNode& add(YamlNode::Kind kind, const YamlEvent& event) {
    refuseDecorations(event);
    if (expectsKey()) fail(event, "a key must be a word");
    if (++nodes_ > kMaxValues)
      fail(event, "a scene must hold at most " + std::to_string(kMaxValues) + " values");
    YamlNode& node = open_.empty() ? document_.root : open_.back().node->children.emplace_back();
    node.kind = kind;
    node.line = event.line;
    if (open_.empty() || !open_.back().has_key) return node;
    node.key = open_.back().key;
    node.line = open_.back().key_line;
    open_.back().has_key = false;
    return node;
  }

  void open(YamlNode& node, const YamlEvent& event) {
    if (open_.size() >= kMaxDepth)
      fail(event, "nested deeper than " + std::to_string(kMaxDepth) + " levels");
    open_.push_back({&node, false, {}, 0, {}});
  }

  const std::string& source_;
  YamlDocument document_;
  std::vector<Open> open_;
  int documents_ = 0;
  std::size_t nodes_ = 0;
};

}  // namespace

const YamlNode* YamlNode::find(std::string_view name) const {
  const auto child = std::find_if(children.begin(), children.end(),
                                  [&](const YamlNode& c) { return c.key == name; });
  return child == children.end() ? nullptr : &*child;
}

std::string_view TextStore::add(std::string_view text) {
  constexpr std::size_t kBlockBytes = 1 << 16;
  if (blocks_.empty() || blocks_.back().capacity() - blocks_.back().size() < text.size() + 1) {
    blocks_.emplace_back();
    blocks_.back().reserve(std::max(kBlockBytes, text.size() + 1));
  }
  std::string& block = blocks_.back();
  const std::size_t at = block.size();
  block.append(text).push_back('\0');
  return {block.data() + at, text.size()};
}

YamlDocument parseYaml(const std::string& yaml_text, const std::string& source_name) {
  if (yaml_text.size() > kMaxSceneBytes)
    throw SceneError(source_name, 0,
                     "is larger than " + std::to_string(kMaxSceneBytes >> 20) + " MiB");
  TreeBuilder builder(source_name);
  readYamlEvents(yaml_text, source_name, [&](const YamlEvent& event) { builder.take(event); });
  return builder.finish();
}

std::string printable(const YamlNode& node) {
  const std::string text = printable(std::string(node.text));
  switch (node.kind) {
    case YamlNode::Kind::kEmpty:
      return "nothing";
    case YamlNode::Kind::kScalar:
      return node.quoted ? "\"" + text + "\"" : text;
    case YamlNode::Kind::kMapping:
      return "a mapping";
    case YamlNode::Kind::kList:
      break;
  }
  std::string list = "[";
  for (const YamlNode& item : node.children) {
    if (list.size() > 60) return list + ", ...]";
    list += (list.size() > 1 ? ", " : "") + printable(item);
  }
  return list + "]";
}

}  // namespace rigid_body_sim
