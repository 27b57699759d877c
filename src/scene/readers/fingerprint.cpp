#include "scene/readers/fingerprint.hpp"

#include <cstdint>
#include <cstdio>

namespace rigid_body_sim {
namespace {

class Fnv1a {
 public:
  void add(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3; }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<unsigned char>(c));
    add(0xff);  // in no text of UTF-8: "ab", "c" is not "a", "bc"
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

void add(const YamlNode& node, Fnv1a& hash) {
  hash.add(static_cast<unsigned char>(node.kind));
  hash.add(node.key);
  hash.add(node.text);
  for (const YamlNode& child : node.children) add(child, hash);
  hash.add(0xfe);  // the end of a list or mapping
}

}  // namespace

std::string fingerprintOf(const YamlNode& root) {
  Fnv1a hash;
  add(root, hash);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash.hash()));
  return digits;
}

}  // namespace rigid_body_sim
