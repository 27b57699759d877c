#pragma once

#include <cstdint>
#include <string>

#include "ros/inputs/seldom.hpp"

namespace rigid_body_sim {

/// Counts refused input and warns of it at most once a second of wall time.
class Refusals {
 public:
  /// what: the kind of input, such as "wrench"; all kinds are counted together.
  void add(const char* what, const std::string& reason);

  /// Adds the reason why input is refused; an empty one means that it is not.
  void check(const char* what, const std::string& reason) {
    if (!reason.empty()) add(what, reason);
  }

  std::int64_t count() const { return count_; }

 private:
  std::int64_t count_ = 0;
  Seldom warning_;
};

}  // namespace rigid_body_sim
