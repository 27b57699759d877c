#pragma once

#include <algorithm>

namespace rigid_body_sim {

/// The tightest tolerance of auto that contact is integrated to: a tighter one changes nothing.
constexpr double kTightestInContact = 1e-10;

/// What the error estimate of a step in contact may reach. Errors grow from impact to impact, so
/// that it lies far below the tolerance; below 1e-14, rounding would decide.
inline double contactStepBound(double tolerance) {
  constexpr double kShare = 1e-4, kLoosest = 1e-6;
  return std::min(kShare * std::max(tolerance, kTightestInContact), kLoosest);
}

}  // namespace rigid_body_sim
