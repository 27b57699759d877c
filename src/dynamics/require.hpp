#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "math/shortest.hpp"

namespace rigid_body_sim {

/// What a rule was broken by, at the end of a message: ", got -0.01".
struct Got {
  double value;
};

inline std::string rulePart(const Got& got) { return ", got " + shortest(got.value); }
inline std::string rulePart(std::size_t number) { return std::to_string(number); }
inline std::string_view rulePart(std::string_view text) { return text; }

/// Throws unless a rule holds: "body 'box': position must be finite". The message is given in parts
/// and joined only where the rule is broken: a sweep checks a million worlds.
template <class... Parts>
void require(bool holds, const Parts&... parts) {
  if (holds) return;
  std::string message;
  (message += ... += rulePart(parts));
  throw std::invalid_argument(message);
}

}  // namespace rigid_body_sim
