#include "scene/readers/entry.hpp"

#include <algorithm>

#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {

namespace {

std::string namesOf(const std::vector<std::pair<std::string, bool>>& keys) {
  std::string names;
  for (const auto& key : keys) names += (names.empty() ? "" : ", ") + key.first;
  return names;
}

}  // namespace

Entry Entry::as(std::string place) const {
  Entry entry = *this;
  entry.place_ = std::move(place);
  entry.key_.clear();
  return entry;
}

Entry Entry::child(const YamlNode& node) const {
  Entry entry = *this;
  entry.node_ = &node;
  entry.key_ = key_.empty() ? node.key : key_ + "." + node.key;
  return entry;
}

std::vector<Entry> Entry::items(const std::string& rule) const {
  if (node_->kind != YamlNode::Kind::kList) failRule(rule);
  std::vector<Entry> entries;
  for (const YamlNode& item : node_->children) {
    Entry entry = *this;
    entry.node_ = &item;
    entry.key_ = key_ + "[" + std::to_string(entries.size()) + "]";
    entries.push_back(std::move(entry));
  }
  return entries;
}

void Entry::checkCount(std::size_t most, const std::string& things) const {
  const std::size_t count = node_->children.size();
  if (count > most)
    fail((key_.empty() ? "" : key_ + " ") + "must hold at most " + std::to_string(most) + " " +
         things + ", got " + std::to_string(count));
}

void Entry::failRule(const std::string& rule) const {
  fail((key_.empty() ? "" : key_ + " ") + rule + ", got " + printable(*node_));
}

void Entry::fail(const std::string& message) const {
  throw SceneError(oneLine(located(message)));  // a path may hold any byte
}

std::string Entry::located(const std::string& message) const {
  return context_->source + ":" + std::to_string(node_->line) + ": " +
         (place_.empty() ? "" : place_ + ": ") + message;
}

void checkKeys(const Entry& mapping, const std::vector<std::pair<std::string, bool>>& known) {
  if (mapping.node().kind != YamlNode::Kind::kMapping) {
    if (mapping.key().empty()) mapping.failRule("a mapping is expected");
    mapping.fail(mapping.key() + " must be a mapping, got " + printable(mapping.node()) +
                 " (keys: " + namesOf(known) + ")");
  }
  for (const YamlNode& node : mapping.node().children) {
    const bool is_known = std::any_of(known.begin(), known.end(),
                                      [&](const auto& key) { return key.first == node.key; });
    if (is_known) continue;
    const Entry unknown = mapping.child(node);
    unknown.fail("unknown key '" + printable(unknown.key()) + "' (known: " + namesOf(known) + ")");
  }
  for (const auto& [name, required] : known) {
    if (!required || mapping.node().find(name)) continue;
    mapping.fail("missing key '" + (mapping.key().empty() ? name : mapping.key() + "." + name) +
                 "'");
  }
}

}  // namespace rigid_body_sim
