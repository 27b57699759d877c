#include "scene/study/scene_path.hpp"

#include <charconv>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

void addPaths(const YamlNode& node, const std::string& path, std::vector<std::string>& paths) {
  if (!path.empty()) paths.push_back(path);
  for (std::size_t i = 0; i < node.children().size() && paths.size() < kMaxComparedNames; ++i) {
    const YamlNode& child = node.children()[i];
    if (node.kind() == YamlNode::Kind::kMapping) {
      addPaths(child, (path.empty() ? "" : path + ".") + std::string(child.key()), paths);
      continue;
    }
    const YamlNode* name = child.find("name");
    addPaths(child,
             name ? path + "." + std::string(name->text()) : path + "[" + std::to_string(i) + "]",
             paths);
  }
}

/// Takes [2] from the front of a text; none where it does not begin so.
std::optional<std::size_t> takeItem(std::string_view& text) {
  const std::size_t end = text.find(']');
  std::size_t item = 0;
  if (end == std::string_view::npos) return std::nullopt;
  const auto [rest, error] = std::from_chars(text.data() + 1, text.data() + end, item);
  if (end == 1 || rest != text.data() + end || error != std::errc()) return std::nullopt;
  text.remove_prefix(end + 1);
  return item;
}

}  // namespace

std::vector<PathStep> stepsOf(const std::string& path) {
  std::vector<PathStep> steps;
  std::string_view rest = path;
  while (!rest.empty()) {
    if (rest.front() == '[') {
      const std::optional<std::size_t> item = takeItem(rest);
      if (!item) return {};
      steps.push_back({"", item});
      continue;
    }
    if (!steps.empty()) {
      if (rest.front() != '.') return {};
      rest.remove_prefix(1);
    }
    const std::size_t end = std::min(rest.find_first_of(".["), rest.size());
    if (end == 0) return {};
    steps.push_back({std::string(rest.substr(0, end)), std::nullopt});
    rest.remove_prefix(end);
  }
  return steps;
}

YamlNode* follow(YamlNode& node, const PathStep& step) {
  const bool list = node.kind() == YamlNode::Kind::kList;
  if (step.item)
    return list && *step.item < node.children().size() ? &node.children()[*step.item] : nullptr;
  for (YamlNode& child : node.children()) {
    const YamlNode* name = list ? child.find("name") : nullptr;
    if (list ? name && name->text() == step.name : child.key() == step.name) return &child;
  }
  return nullptr;
}

YamlNode* nodeAt(YamlNode& root, const std::string& path) {
  const std::vector<PathStep> steps = stepsOf(path);
  YamlNode* node = steps.empty() ? nullptr : &root;
  for (const PathStep& step : steps)
    if (!node || !(node = follow(*node, step))) return nullptr;
  return node;
}

std::vector<std::string> pathsOf(const YamlNode& root) {
  std::vector<std::string> paths;
  addPaths(root, "", paths);
  return paths;
}

}  // namespace rigid_body_sim
