#pragma once

#include <algorithm>
#include <limits>

#include "dynamics/contact/feature.hpp"

namespace rigid_body_sim {

/// [s] For how long a bound under a torque is valid.
constexpr double kTurningTime = 1;

/// The first root after 0 of gap + speed τ + ½ acceleration τ², of gap >= 0, acceleration <= 0;
/// infinity where there is none.
double firstRoot(double gap, double speed, double acceleration);

/// The root of a concave function that is not negative at 0, from below; infinity where there is
/// none. Wherever it is positive on the right, it is positive in between.
template <class F>
double lastRoot(const F& gap, double guess) {
  constexpr double kFar = 1e9;  // [s]
  double low = 0, high = guess;
  while (gap(high) >= 0) {
    low = high;
    high *= 4;
    if (high > kFar) return std::numeric_limits<double>::infinity();
  }
  for (int i = 0; i < 100 && high - low > 1e-3 * high; ++i) {
    const double g_low = gap(low), g_high = gap(high);
    // the chord of a concave function lies below it: its root is certain
    const double chord = low + (high - low) * (g_low / (g_low - g_high));
    const double middle = 0.5 * (low + high);
    if (chord > low && chord < high && gap(chord) >= 0) low = chord;
    (gap(middle) >= 0 ? low : high) = std::max(low, middle);
  }
  return low;
}

/// How fast the points of a body may leave their tangents, as it turns.
///   ω² <= min(2 T/I_min, (L/I_min)²),   |α| <= ½ ω² max|I_i − I_j|/I_k + τ/I_min
/// Returns |α| + ω² [1/s²]; under a torque, over the next `duration`.
double turningBound(const Body& body, const BodyState& state, double torque, double duration);

/// A lower bound on the gap between a body in flight and a plane: with m = −Rᵀ n, m' = m × ω, h the
/// support function, a the acceleration and x the centre of mass,
///   gap(τ) >= n · (x + v τ + ½ a τ²) − h(m + τ m') − ½ B τ²,   B = (|α| + ω²) reach + |a| off,
/// since the body turns out of m + τ m' by at most ½ (|α| + ω²) τ². It is concave in τ where a does
/// not lead away from the plane; there a is left out.
class PlaneFlight {
 public:
  PlaneFlight(const Body& body, const BodyState& state, const HalfSpace& plane,
              const MotionBound& bound);

  /// [s] For how long a feature cannot touch the plane, at least.
  double clearFor(const Feature& feature) const;

  /// [s] The same of everything within `reach` [m] of the centre of mass: coarser, and quicker.
  /// Zero unless that is as far away again.
  double clearFor(double reach) const;

 private:
  double height_, low_;  // [m] of the centre of mass above the plane, in two parts
  double speed_;         // [m/s] away from the plane
  double acceleration_;  // [m/s²] the least away from the plane; at most zero
  double turning_;       // [1/s²]
  double horizon_;       // [s] for how long all this holds
  Vector3d m_P_, m_dot_P_;
};

}  // namespace rigid_body_sim
