#pragma once

#include <algorithm>

namespace rigid_body_sim {

/// [s] An instant that misses a step at t by less is there: rounding of a quotient and of a
/// product.
inline double instantRounding(double t, double time_step) {
  return std::max(1e-9 * time_step, 1e-15 * t);
}

}  // namespace rigid_body_sim
