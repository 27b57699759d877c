#pragma once

#include <cstdint>
#include <string_view>

namespace rigid_body_sim {

/// The hash FNV-1a of 64 bits (Fowler, Noll and Vo), byte by byte.
class Fnv1a {
 public:
  void add(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001B3; }
  void add(std::string_view bytes) {
    for (const char c : bytes) add(static_cast<unsigned char>(c));
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325;
};

}  // namespace rigid_body_sim
