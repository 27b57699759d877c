#pragma once

#include <string>
#include <vector>

namespace rigid_body_sim {

/// "a, b, c" for a message; cut short after the first ten.
inline std::string nameList(const std::vector<std::string>& names) {
  constexpr std::size_t kMaxNames = 10;
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += ", ";
    if (i == kMaxNames) return list + "...";
    list += names[i];
  }
  return list;
}

}  // namespace rigid_body_sim
