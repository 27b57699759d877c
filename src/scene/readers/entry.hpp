#pragma once

#include <string>
#include <utility>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

#include "scene/readers/read_context.hpp"
#include "scene/readers/yaml_tree.hpp"

namespace rigid_body_sim {

/// A value of the file together with all that a message about it has to name.
class Entry {
 public:
  Entry(ReadContext& context, const YamlNode& node) : context_(&context), node_(&node) {}

  /// The same value as the root of a part of the file that has a name of its own.
  Entry as(std::string place) const;

  Entry child(const YamlNode& node) const;

  /// The items of a list; refuses anything else. `rule` says what the list must be.
  std::vector<Entry> items(const std::string& rule) const;

  /// Refuses a list or mapping of more than that many `things`.
  void checkCount(std::size_t most, const std::string& things) const;

  const YamlNode& node() const { return *node_; }
  const std::string& key() const { return key_; }
  ReadContext& context() const { return *context_; }

  /// file:line: place: <message>
  std::string located(const std::string& message) const;

  /// file:line: place: key <rule>, got <value>
  [[noreturn]] void failRule(const std::string& rule) const;

  /// file:line: place: <message>
  [[noreturn]] void fail(const std::string& message) const;

 private:
  ReadContext* context_;
  const YamlNode* node_;
  std::string place_;  ///< such as "body 'top'"
  std::string key_;    ///< within the place, such as "twist.linear"
};

/// How a key of a mapping is read into the struct that mirrors the mapping.
template <class Def>
struct Key {
  const char* name;
  void (*read)(const Entry& value, Def& def);
  bool required = false;
};

/// Refuses what is not a mapping, keys that are not in `known` and required ones that are absent.
void checkKeys(const Entry& mapping, const std::vector<std::pair<std::string, bool>>& known);

/// Reads a mapping key by key, in the order of the file.
template <class Def>
void readMapping(const Entry& mapping, const std::vector<Key<Def>>& keys, Def& def) {
  std::vector<std::pair<std::string, bool>> known;
  known.reserve(keys.size());
  for (const Key<Def>& key : keys) known.emplace_back(key.name, key.required);
  checkKeys(mapping, known);
  for (const YamlNode& node : mapping.node().children) {
    for (const Key<Def>& key : keys) {
      if (node.key == key.name) key.read(mapping.child(node), def);
    }
  }
}

// Values. Each throws SceneError unless the value is what its name says.

bool readBoolean(const Entry& value);
std::string readText(const Entry& value);
std::string readTextOrNone(const Entry& value);  ///< may be empty

/// A name of a body or point: [A-Za-z][A-Za-z0-9_]*, at most kMostNameBytes long
std::string readName(const Entry& value);
bool isName(const std::string& text);

/// The same as a message says it.
std::string nameRule();

/// A name in tf, such as base-link or arm/wrist.
std::string readFrameName(const Entry& value);
bool isFrameName(const std::string& text);
std::string frameNameRule();

/// The nearest double; finite. `unit` is for the message; empty: a pure number.
double readNumber(const Entry& value, const std::string& unit);
double readPositive(const Entry& value, const std::string& unit);
double readNotNegative(const Entry& value, const std::string& unit);
/// > 0, .inf included
double readDuration(const Entry& value);
Vector3d readVector3(const Entry& value, const std::string& unit);
std::vector<double> readNumbers(const Entry& value, std::size_t count, const std::string& unit);

/// [x, y, z, w], normalised, its norm within 1e-3 of 1; or {rpy: [roll, pitch, yaw]}.
Quaterniond readOrientation(const Entry& value);

}  // namespace rigid_body_sim
