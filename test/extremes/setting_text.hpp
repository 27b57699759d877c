#pragma once

#include <cstdio>
#include <string>

namespace rigid_body_sim::extremes {

/// A number as a setting is called by it.
inline std::string settingText(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%g", value);
  return digits;
}

}  // namespace rigid_body_sim::extremes
