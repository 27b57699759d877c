#pragma once

#include <stdexcept>
#include <string>

#include "math/shortest.hpp"

namespace rigid_body_sim {

/// Throws unless a rule holds: "body 'box': position must be finite".
inline void require(bool holds, const std::string& rule) {
  if (!holds) throw std::invalid_argument(rule);
}

/// "time_step must be > 0 s, got -0.01"
inline void require(bool holds, const std::string& rule, double got) {
  if (holds) return;
  throw std::invalid_argument(rule + ", got " + shortest(got));
}

}  // namespace rigid_body_sim
