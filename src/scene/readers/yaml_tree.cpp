#include "scene/readers/yaml_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/limits.hpp"
#include "scene/readers/plain_yaml.hpp"
#include "scene/readers/yaml_events.hpp"

namespace rigid_body_sim {
namespace {

/// Builds the tree while the parser reads, so that excess is refused before it costs anything. The
/// children of a list or mapping wait on a stack until its end, and then get their place in one.
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
        return open(YamlNode::Kind::kList, event);
      case YAML_MAPPING_START_EVENT:
        return open(YamlNode::Kind::kMapping, event);
      case YAML_SEQUENCE_END_EVENT:
      case YAML_MAPPING_END_EVENT:
        return close();
      default:
        return;  // starts and ends of the stream, ends of documents
    }
  }

  YamlDocument finish() {
    if (documents_ == 0) throw SceneError(source_, 0, "is empty; it must be a YAML mapping");
    document_.root = waiting_.front();
    return std::move(document_);
  }

 private:
  /// A list or mapping whose end is still to come. Its children are those that wait behind it.
  struct Open {
    YamlNode::Kind kind;
    std::size_t first;     ///< where its children begin
    bool has_key = false;  ///< a key waits for its value
    std::string_view key{};
    int key_line = 0;
    std::unordered_set<std::string_view> keys{};  ///< of a mapping of many, else empty
  };

  [[noreturn]] void fail(const YamlEvent& event, const std::string& message) const {
    throw SceneError(source_, event.line, message);
  }
  [[noreturn]] void failOnAnchor(const YamlEvent& event) const {
    fail(event, "YAML anchors (&) and aliases (*) are not allowed");
  }

  bool expectsKey() const {
    return !open_.empty() && open_.back().kind == YamlNode::Kind::kMapping && !open_.back().has_key;
  }

  void refuseDecorations(const YamlEvent& event) const {
    if (event.has_anchor) failOnAnchor(event);
    if (!event.tag.empty())
      fail(event, "YAML tags are not allowed, got " + printable(std::string(event.tag)));
  }

  void takeScalar(const YamlEvent& event) {
    if (event.text.size() > kMaxTextBytes)
      fail(event, "a text must have at most " + std::to_string(kMaxTextBytes) + " bytes, got " +
                      std::to_string(event.text.size()));
    if (expectsKey() && !event.isNull()) return takeKey(event);
    YamlNode& node = add(event);
    if (!event.isNull()) node.setScalar(document_.keep(event.text), event.quoted);
  }

  void takeKey(const YamlEvent& event) {
    refuseDecorations(event);
    Open& mapping = open_.back();
    mapping.key = document_.keep(event.text);
    if (isRepeated(mapping))
      fail(event, "key '" + printable(std::string(event.text)) + "' is repeated");
    mapping.has_key = true;
    mapping.key_line = event.line;
  }

  /// Whether the mapping has its new key already. Few keys are compared one by one, many by a
  /// table.
  bool isRepeated(Open& mapping) const {
    constexpr std::size_t kFew = 32;
    const auto first = waiting_.begin() + static_cast<std::ptrdiff_t>(mapping.first);
    if (waiting_.size() - mapping.first < kFew)
      return std::any_of(first, waiting_.end(),
                         [&](const YamlNode& value) { return value.key() == mapping.key; });
    if (mapping.keys.empty())
      std::for_each(first, waiting_.end(),
                    [&](const YamlNode& value) { mapping.keys.insert(value.key()); });
    return !mapping.keys.insert(mapping.key).second;
  }

  YamlNode& add(const YamlEvent& event) {
    refuseDecorations(event);
    if (expectsKey()) fail(event, "a key must be a word");
    if (++nodes_ > kMaxValues)
      fail(event, "a scene must hold at most " + std::to_string(kMaxValues) + " values");
    YamlNode& node = waiting_.emplace_back();
    if (open_.empty() || !open_.back().has_key) {
      node.setPlace("", event.line);
    } else {
      node.setPlace(open_.back().key, open_.back().key_line);
      open_.back().has_key = false;
    }
    return node;
  }

  void open(YamlNode::Kind kind, const YamlEvent& event) {
    add(event);
    if (open_.size() >= kMaxDepth)
      fail(event, "nested deeper than " + std::to_string(kMaxDepth) + " levels");
    open_.push_back({kind, waiting_.size()});
  }

  void close() {
    const Open& closed = open_.back();
    const auto first = waiting_.begin() + static_cast<std::ptrdiff_t>(closed.first);
    const YamlNodes<YamlNode> children = document_.makeNodes(waiting_.size() - closed.first);
    std::copy(first, waiting_.end(), children.begin());
    waiting_.erase(first, waiting_.end());
    waiting_.back().setChildren(closed.kind, children);
    open_.pop_back();
  }

  const std::string& source_;
  YamlDocument document_;
  std::vector<YamlNode> waiting_;  ///< their lists or mappings have not ended
  std::vector<Open> open_;
  int documents_ = 0;
  std::size_t nodes_ = 0;
};

/// None where the text is not plain, or breaks a rule: then the reader of all YAML says which.
std::optional<YamlDocument> plainDocument(const std::string& yaml_text, const std::string& source) {
  TreeBuilder builder(source);
  try {
    if (readPlainYaml(yaml_text, [&](const YamlEvent& event) { builder.take(event); }))
      return builder.finish();
  } catch (const SceneError&) {
  }
  return std::nullopt;
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view name) const {
  const YamlNodes<const YamlNode> all = children();
  const YamlNode* child =
      std::find_if(all.begin(), all.end(), [&](const YamlNode& c) { return c.key() == name; });
  return child == all.end() ? nullptr : child;
}

void YamlNode::setPlace(std::string_view key, int line) {
  static_assert(kMaxTextBytes <= std::numeric_limits<decltype(key_size_)>::max());
  key_ = key.data();
  key_size_ = static_cast<std::uint16_t>(key.size());
  line_ = line;
}

void YamlNode::setScalar(std::string_view text, bool quoted) {
  kind_ = Kind::kScalar;
  text_ = text.data();
  size_ = static_cast<std::uint32_t>(text.size());
  quoted_ = quoted;
}

void YamlNode::setChildren(Kind list_or_mapping, YamlNodes<YamlNode> children) {
  kind_ = list_or_mapping;
  first_ = children.begin();
  size_ = static_cast<std::uint32_t>(children.size());
}

std::string_view YamlDocument::keep(std::string_view text) {
  char* kept = texts.make(text.size() + 1);
  std::copy(text.begin(), text.end(), kept);
  return {kept, text.size()};
}

YamlDocument parseYaml(const std::string& yaml_text, const std::string& source_name) {
  if (yaml_text.size() > kMaxSceneBytes)
    throw SceneError(source_name, 0,
                     "is larger than " + std::to_string(kMaxSceneBytes >> 20) + " MiB");
  if (std::optional<YamlDocument> plain = plainDocument(yaml_text, source_name))
    return std::move(*plain);
  TreeBuilder builder(source_name);
  readYamlEvents(yaml_text, source_name, [&](const YamlEvent& event) { builder.take(event); });
  return builder.finish();
}

std::string printable(const YamlNode& node) {
  const std::string text = printable(std::string(node.text()));
  switch (node.kind()) {
    case YamlNode::Kind::kEmpty:
      return "nothing";
    case YamlNode::Kind::kScalar:
      return node.quoted() ? "\"" + text + "\"" : text;
    case YamlNode::Kind::kMapping:
      return "a mapping";
    case YamlNode::Kind::kList:
      break;
  }
  std::string list = "[";
  for (const YamlNode& item : node.children()) {
    if (list.size() > 60) return list + ", ...]";
    list += (list.size() > 1 ? ", " : "") + printable(item);
  }
  return list + "]";
}

}  // namespace rigid_body_sim
