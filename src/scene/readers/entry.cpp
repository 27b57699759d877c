#include "scene/readers/entry.hpp"

#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {
namespace {

std::string namesOf(const std::vector<KeyName>& keys) {
  std::string names;
  for (const KeyName& key : keys) {
    if (!names.empty()) names += ", ";
    names += key.name;
  }
  return names;
}

}  // namespace

Entry Entry::as(std::string place) const {
  Entry entry(*context_, *node_);
  entry.place_ = std::move(place);
  return entry;
}

Entry Entry::child(const YamlNode& node) const& {
  Entry entry(*context_, node);
  entry.parent_ = this;
  return entry;
}

Entry Entry::item(std::size_t number) const& {
  Entry entry = child(node_->children()[number]);
  entry.item_ = number;
  return entry;
}

std::vector<Entry> Entry::items(const std::string& rule) const& {
  if (node_->kind() != YamlNode::Kind::kList) failRule(rule);
  std::vector<Entry> entries;
  entries.reserve(node_->children().size());
  for (std::size_t i = 0; i < node_->children().size(); ++i) entries.push_back(item(i));
  return entries;
}

void Entry::checkCount(std::size_t most, const std::string& things) const {
  const std::size_t count = node_->children().size();
  if (count > most)
    fail((key().empty() ? "" : key() + " ") + "must hold at most " + std::to_string(most) + " " +
         things + ", got " + std::to_string(count));
}

std::string Entry::key() const {
  if (!parent_) return "";
  const std::string before = parent_->key();
  if (item_ != kNoItem) return before + "[" + std::to_string(item_) + "]";
  return (before.empty() ? "" : before + ".") + std::string(node_->key());
}

const std::string& Entry::place() const { return parent_ ? parent_->place() : place_; }

void Entry::failRule(const std::string& rule) const {
  fail((key().empty() ? "" : key() + " ") + rule + ", got " + printable(*node_));
}

void Entry::fail(const std::string& message) const {
  throw SceneError(oneLine(located(message)));  // a path may hold any byte
}

std::string Entry::located(const std::string& message) const {
  // what the core says of a body begins with its name, too
  const bool is_named = message.compare(0, place().size(), place()) == 0;
  return context_->source + ":" + std::to_string(node_->line()) + ": " +
         (is_named ? "" : place() + ": ") + message;
}

void Entry::note(const std::string& message) const {
  context_->notices.push_back(oneLine(located(key() + ": " + message)));
}

void refuseKeys(const Entry& value, const std::vector<KeyName>& known) {
  if (value.node().kind() != YamlNode::Kind::kMapping) {
    if (value.key().empty()) value.failRule("a mapping is expected");
    value.fail(value.key() + " must be a mapping, got " + printable(value.node()) +
               " (keys: " + namesOf(known) + ")");
  }
  for (const YamlNode& node : value.node().children()) {
    const bool is_known = std::any_of(known.begin(), known.end(),
                                      [&](const KeyName& key) { return key.name == node.key(); });
    const Entry child = value.child(node);
    if (!is_known)
      child.fail("unknown key '" + printable(child.key()) + "' (known: " + namesOf(known) + ")");
  }
  for (const KeyName& key : known) {
    if (!key.required || value.node().find(key.name)) continue;
    value.fail("missing key '" + (value.key().empty() ? "" : value.key() + ".") +
               std::string(key.name) + "'");
  }
}

}  // namespace rigid_body_sim
