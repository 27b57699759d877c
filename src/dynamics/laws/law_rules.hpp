#pragma once

#include <cmath>

#include <rigid_body_sim/math/types.hpp>

#include "dynamics/require.hpp"

/// Rules of what a law is made of. Each throws std::invalid_argument.
namespace rigid_body_sim {

inline void requireRule(bool holds, const char* law, const char* rule, double got) {
  require(holds && std::isfinite(got), "law '", law, "': ", rule, " and finite", Got{got});
}

/// rule: such as "stiffness must be >= 0 N/m"
inline void requireNotNegative(const char* law, const char* rule, double got) {
  requireRule(got >= 0, law, rule, got);
}

inline void requirePositive(const char* law, const char* rule, double got) {
  requireRule(got > 0, law, rule, got);
}

inline void requireFinite(const char* law, const char* what, const Vector3d& v) {
  require(v.allFinite(), "law '", law, "': ", what, " must be finite");
}

}  // namespace rigid_body_sim
