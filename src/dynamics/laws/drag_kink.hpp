#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// [s] From a kink of quadratic drag that is alike in every direction: |u| u has one where u = 0,
/// and nearly one where u passes close by. At a constant rate u′ the instants at which u · u is
/// zero are complex: |u|/|u′| from the present, and |u × u′|/|u′|² off the real ones. Infinite
/// where they are a step of h or more off: shorter steps then converge as they do elsewhere.
///
/// What the kink does to u within δ of it is strength (|u′| δ)² δ. Where that is below `negligible`
/// of what u changes by within h, no step need be shorter; so the kink is taken to be no closer. u
/// [m/s], change: u′ [m/s²], along the same axes; strength: quadratic × mobility [1/m].
inline double distanceToDragKink(const Vector3d& u, const Vector3d& change, double strength,
                                 double h, double negligible) {
  const double rate = change.norm();
  if (!(rate > 0) || !(u.cross(change / rate).norm() < rate * h))
    return std::numeric_limits<double>::infinity();
  return std::max(u.norm() / rate, std::cbrt(negligible * h / (strength * rate)));
}

}  // namespace rigid_body_sim
