#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

#include "scene/readers/read_context.hpp"
#include "scene/readers/yaml_tree.hpp"

namespace rigid_body_sim {

/// A value of the file together with all that a message about it has to name. An entry refers to
/// the one that it was taken from, which must outlive it: what a message says of the way there is
/// put together only when it is needed.
class Entry {
 public:
  Entry(ReadContext& context, const YamlNode& node) : context_(&context), node_(&node) {}

  /// The same value as the root of a part of the file that has a name of its own.
  Entry as(std::string place) const;

  Entry child(const YamlNode& node) const&;
  Entry child(const YamlNode& node) const&& = delete;

  /// An item of a list that has it.
  Entry item(std::size_t number) const&;
  Entry item(std::size_t number) const&& = delete;

  /// The items of a list; refuses anything else. `rule` says what the list must be.
  std::vector<Entry> items(const std::string& rule) const&;
  std::vector<Entry> items(const std::string& rule) const&& = delete;

  /// Refuses a list or mapping of more than that many `things`.
  void checkCount(std::size_t most, const std::string& things) const;

  const YamlNode& node() const { return *node_; }
  ReadContext& context() const { return *context_; }

  /// Within its place, such as "twist.linear".
  std::string key() const;

  /// file:line: place: <message>
  std::string located(const std::string& message) const;

  /// Adds a notice to those of the scene.  file:line: place: key: <message>
  void note(const std::string& message) const;

  /// file:line: place: key <rule>, got <value>
  [[noreturn]] void failRule(const std::string& rule) const;

  /// file:line: place: <message>
  [[noreturn]] void fail(const std::string& message) const;

 private:
  static constexpr std::size_t kNoItem = static_cast<std::size_t>(-1);

  const std::string& place() const;

  ReadContext* context_;
  const YamlNode* node_;
  const Entry* parent_ = nullptr;
  std::size_t item_ = kNoItem;  ///< its number where the parent is a list
  std::string place_;           ///< such as "body 'top'"; where there is no parent
};

/// How a key of a mapping is read into the struct that mirrors the mapping.
template <class Def>
struct Key {
  std::string_view name;
  void (*read)(const Entry& value, Def& def);
  bool required = false;
};

struct KeyName {
  std::string_view name;
  bool required;
};

/// Says what is wrong with a value that is no mapping, has a key that is not known, or lacks one
/// that is required. A mapping without fault returns.
void refuseKeys(const Entry& value, const std::vector<KeyName>& known);

/// Reads a mapping key by key, in the order of the file. keys: static, as for many bodies.
template <class Def>
void readMapping(const Entry& mapping, const std::vector<Key<Def>>& keys, Def& def) {
  const auto keyOf = [&](const YamlNode& node) {
    return std::find_if(keys.begin(), keys.end(),
                        [&](const Key<Def>& key) { return key.name == node.key(); });
  };
  const YamlNodes<const YamlNode> values = mapping.node().children();
  bool faulty = mapping.node().kind() != YamlNode::Kind::kMapping;
  auto missing =
      std::count_if(keys.begin(), keys.end(), [](const auto& key) { return key.required; });
  for (const YamlNode& value : values) {  // none is repeated
    const auto key = keyOf(value);
    faulty |= key == keys.end();
    missing -= key != keys.end() && key->required;
  }
  if (faulty || missing > 0) {
    std::vector<KeyName> names;
    names.reserve(keys.size());
    for (const Key<Def>& key : keys) names.push_back({key.name, key.required});
    refuseKeys(mapping, names);
  }
  for (const YamlNode& value : values) keyOf(value)->read(mapping.child(value), def);
}

// Values. Each throws SceneError unless the value is what its name says.

bool readBoolean(const Entry& value);
std::string readText(const Entry& value);
std::string readTextOrNone(const Entry& value);  ///< may be empty

/// A name of a body or point: [A-Za-z][A-Za-z0-9_]*, at most kMaxNameBytes long
std::string readName(const Entry& value);
bool isName(std::string_view text);

/// The same as a message says it.
std::string nameRule();

/// A name in tf, such as base-link or arm/wrist.
std::string readFrameName(const Entry& value);
bool isFrameName(std::string_view text);
std::string frameNameRule();

/// The number that a plain scalar stands for, .inf and .nan included; none where it is no number.
std::optional<double> numberIn(const YamlNode& node);

/// The nearest double; finite. `unit` is for the message; empty: a pure number.
double readNumber(const Entry& value, const std::string& unit);
std::uint64_t readWhole(const Entry& value, std::uint64_t least = 0,
                        std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
/// ±.inf included
double readBound(const Entry& value, const std::string& unit);
double readPositive(const Entry& value, const std::string& unit);
double readNotNegative(const Entry& value, const std::string& unit);
/// > 0, .inf included
double readDuration(const Entry& value);
Vector3d readVector3(const Entry& value, const std::string& unit);
std::vector<double> readNumbers(const Entry& value, std::size_t count, const std::string& unit);

/// [x, y, z, w], normalised, its norm within 1e-3 of 1; or {rpy: [roll, pitch, yaw]}.
Quaterniond readOrientation(const Entry& value);

}  // namespace rigid_body_sim
