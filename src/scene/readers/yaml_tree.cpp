#include "scene/readers/yaml_tree.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

/// Builds the tree while yaml-cpp parses, so that excess depth and aliases are refused before they
/// cost anything.
class TreeBuilder final : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const std::string& source) : source_(source) {}

  YamlNode takeRoot() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) fail(mark, "a second YAML document; a scene file holds one");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(YamlNode::Kind::kEmpty, mark, "", anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { failOnAnchor(mark); }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    checkLength(mark, value);
    if (expectsKey()) {
      refuseDecorations(mark, tag, anchor);
      return takeKey(mark, value);
    }
    YamlNode& node = add(YamlNode::Kind::kScalar, mark, tag, anchor);
    node.text = value;
    node.quoted = tag == "!";
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(add(YamlNode::Kind::kList, mark, tag, anchor), mark);
  }
  void OnSequenceEnd() override { open_.pop_back(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(add(YamlNode::Kind::kMapping, mark, tag, anchor), mark);
  }
  void OnMapEnd() override { open_.pop_back(); }

 private:
  /// A list or mapping whose end is still to come.
  struct Open {
    YamlNode* node;
    bool has_key = false;  ///< a key waits for its value
    std::string key;
    int key_line = 0;
    std::set<std::string> keys;
  };

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) const {
    throw SceneError(source_, mark.line + 1, message);
  }
  [[noreturn]] void failOnAnchor(const YAML::Mark& mark) const {
    fail(mark, "YAML anchors (&) and aliases (*) are not allowed in a scene");
  }

  bool expectsKey() const {
    return !open_.empty() && open_.back().node->kind == YamlNode::Kind::kMapping &&
           !open_.back().has_key;
  }

  // yaml-cpp marks a plain value without a tag by "?", a quoted one by "!"
  void refuseDecorations(const YAML::Mark& mark, const std::string& tag,
                         YAML::anchor_t anchor) const {
    if (anchor != YAML::NullAnchor) failOnAnchor(mark);
    if (!tag.empty() && tag != "?" && tag != "!")
      fail(mark, "YAML tags are not allowed in a scene, got " + printable(tag));
  }

  void checkLength(const YAML::Mark& mark, const std::string& text) const {
    if (text.size() > kMostTextBytes)
      fail(mark, "a text must have at most " + std::to_string(kMostTextBytes) + " bytes, got " +
                     std::to_string(text.size()));
  }

  void takeKey(const YAML::Mark& mark, const std::string& key) {
    Open& mapping = open_.back();
    if (!mapping.keys.insert(key).second) fail(mark, "key '" + printable(key) + "' is repeated");
    mapping.has_key = true;
    mapping.key = key;
    mapping.key_line = mark.line + 1;
  }

  YamlNode& add(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
                YAML::anchor_t anchor) {
    refuseDecorations(mark, tag, anchor);
    if (expectsKey()) fail(mark, "a key must be a word");
    YamlNode node;
    node.kind = kind;
    node.line = mark.line + 1;
    if (open_.empty()) {
      root_ = std::move(node);
      return root_;
    }
    Open& parent = open_.back();
    if (parent.has_key) {
      node.key = parent.key;
      node.line = parent.key_line;
      parent.has_key = false;
    }
    parent.node->children.push_back(std::move(node));
    return parent.node->children.back();
  }

  void open(YamlNode& node, const YAML::Mark& mark) {
    if (open_.size() >= kMostDepth)
      fail(mark, "nested deeper than " + std::to_string(kMostDepth) + " levels");
    open_.push_back({&node, false, "", 0, {}});
  }

  const std::string& source_;
  YamlNode root_;
  std::vector<Open> open_;
  int documents_ = 0;
};

/// What has to be refused before yaml-cpp sees it: it keeps every bracket that is not closed yet as
/// the possible start of a key, 240 bytes each.
void checkSize(const std::string& yaml_text, const std::string& source) {
  if (yaml_text.size() > kMostSceneBytes)
    throw SceneError(source, 0, "is larger than " + std::to_string(kMostSceneBytes >> 20) + " MiB");
  const auto brackets = static_cast<std::size_t>(std::count_if(
      yaml_text.begin(), yaml_text.end(), [](char c) { return c == '[' || c == '{'; }));
  if (brackets > kMostBrackets)
    throw SceneError(source, 0,
                     "must hold at most " + std::to_string(kMostBrackets) +
                         " brackets [ and {, got " + std::to_string(brackets));
}

}  // namespace

const YamlNode* YamlNode::find(const std::string& name) const {
  const auto child = std::find_if(children.begin(), children.end(),
                                  [&](const YamlNode& c) { return c.key == name; });
  return child == children.end() ? nullptr : &*child;
}

YamlNode parseYaml(const std::string& yaml_text, const std::string& source_name) {
  checkSize(yaml_text, source_name);
  TreeBuilder builder(source_name);
  std::istringstream stream(yaml_text);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder))
      throw SceneError(source_name, 0, "is empty; a scene is a YAML mapping");
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& e) {
    throw SceneError(source_name, e.mark.line + 1, "not YAML: " + printable(e.msg));
  }
  return builder.takeRoot();
}

std::string printable(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::kEmpty:
      return "nothing";
    case YamlNode::Kind::kScalar:
      return node.quoted ? "\"" + printable(node.text) + "\"" : printable(node.text);
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
