#include "scene/study/yaml_text.hpp"

#include <array>
#include <cstdio>

namespace rigid_body_sim {
namespace {

std::string quotedText(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    std::array<char, 8> escaped{};
    if (c == '"' || c == '\\') {
      quoted += std::string("\\") + c;
    } else if (code < 0x20 || code == 0x7f) {
      std::snprintf(escaped.data(), escaped.size(), "\\x%02x", code);
      quoted += escaped.data();
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

bool isPlain(std::string_view text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == '+' || c == '/' || c == '-';
  };
  if (text.empty() || text.front() == '-') {
    // a number may begin with a minus, a dash would begin a list
    if (text.size() < 2 || !(text[1] == '.' || (text[1] >= '0' && text[1] <= '9'))) return false;
  }
  for (const char c : text)
    if (!plain(c)) return false;
  return true;
}

/// A file that the scene names relative to its own directory, else the text as it is.
std::string absolutePath(const YamlNode& node, const std::filesystem::path& directory) {
  const bool names_file = node.key() == "file" || node.key() == "mesh";
  const std::filesystem::path path{std::string(node.text())};
  if (!names_file || path.is_absolute() || node.text().find("://") != std::string_view::npos)
    return std::string(node.text());
  return std::filesystem::absolute(directory / path).lexically_normal().string();
}

std::string scalarText(const YamlNode& node, const std::filesystem::path& directory) {
  const std::string text = absolutePath(node, directory);
  return node.quoted() || !isPlain(text) ? quotedText(text) : text;
}

std::string keyText(std::string_view key) {
  return isPlain(key) ? std::string(key) : quotedText(key);
}

std::string flowText(const YamlNode& node, const std::filesystem::path& directory) {
  using Kind = YamlNode::Kind;
  if (node.kind() == Kind::kEmpty) return "~";
  if (node.kind() == Kind::kScalar) return scalarText(node, directory);
  const bool mapping = node.kind() == Kind::kMapping;
  std::string text = mapping ? "{" : "[";
  for (const YamlNode& child : node.children()) {
    if (&child != &node.children().front()) text += ", ";
    if (mapping) text += keyText(child.key()) + ": ";
    text += flowText(child, directory);
  }
  return text + (mapping ? "}" : "]");
}

bool holdsMappings(const YamlNode& node) {
  return node.kind() == YamlNode::Kind::kList && !node.children().empty() &&
         node.children().front().kind() == YamlNode::Kind::kMapping;
}

}  // namespace

std::string yamlText(const YamlNode& root, const std::filesystem::path& directory) {
  std::string text;
  for (const YamlNode& node : root.children()) {
    text += keyText(node.key()) + ":";
    if (!holdsMappings(node)) {
      text += " " + flowText(node, directory) + "\n";
      continue;
    }
    text += "\n";
    for (const YamlNode& item : node.children()) text += "  - " + flowText(item, directory) + "\n";
  }
  return text;
}

}  // namespace rigid_body_sim
