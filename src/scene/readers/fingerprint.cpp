#include "scene/readers/fingerprint.hpp"

#include <cstdio>

#include "math/fnv1a.hpp"

namespace rigid_body_sim {
namespace {

void add(std::string_view text, Fnv1a& hash) {
  hash.add(text);
  hash.add(static_cast<unsigned char>(0xff));  // in no text of UTF-8: "ab", "c" is not "a", "bc"
}

void addAllBut(std::string_view left_out, const YamlNode& node, Fnv1a& hash) {
  hash.add(static_cast<unsigned char>(node.kind()));
  add(node.key(), hash);
  add(node.text(), hash);
  for (const YamlNode& child : node.children())
    if (left_out.empty() || child.key() != left_out) addAllBut("", child, hash);
  hash.add(static_cast<unsigned char>(0xfe));  // the end of a list or mapping
}

}  // namespace

std::string fingerprintOf(const YamlNode& root) {
  Fnv1a hash;
  addAllBut("threads", root, hash);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash.hash()));
  return digits;
}

}  // namespace rigid_body_sim
