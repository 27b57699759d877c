#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <rigid_body_sim/dynamics/state.hpp>

/// Bounds on the motion of a body in flight, from which laws tell when they cannot act.
namespace rigid_body_sim {

/// [s] For how long a bound under a torque is valid.
constexpr double kTurningTime = 1;

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

/// [s] A guess at the root of `room` − speed τ − ½ bend τ², all >= 0, from which lastRoot searches.
/// 1e-300 keeps 0/0 out of it where nothing moves; and since lastRoot multiplies the guess until it
/// is beyond the root, it must not be zero: 1e-18 s is below every rounding of the time.
inline double firstGuess(double room, double speed, double bend) {
  return std::max(room / (speed + std::sqrt(bend * room) + 1e-300), 1e-18);
}

/// How fast the points of a body may leave their tangents, as it turns.
///   ω² <= min(2 T/I_min, (L/I_min)²),   |α| <= ½ ω² max|I_i − I_j|/I_k + τ/I_min
/// Returns |α| + ω² [1/s²]; under a torque, over the next `duration`.
double turningBound(const Body& body, const BodyState& state, double torque, double duration);

}  // namespace rigid_body_sim
