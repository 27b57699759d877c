#pragma once

#include <cstddef>
#include <limits>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/dynamics/state.hpp>

#include "dynamics/step_too_long.hpp"
#include "dynamics/taylor/taylor_equations.hpp"
#include "dynamics/taylor/taylor_recursion.hpp"
#include "dynamics/wrenches/held_wrench.hpp"

namespace rigid_body_sim {

/// A bound on the error of a run, and the time over which it is to hold.
struct ErrorBound {
  double attitude = 0;  ///< [rad]; below rounding, such as 0: to rounding
  double horizon = 0;   ///< [s]
};

/// The motion of one body from a start on, under a wrench that stays constant in the world or in
/// the body: its Taylor series about the start, for as long as validFor() says.
///
/// With such a wrench the equations are polynomial, so that each coefficient follows from those
/// before it by sums of products, R being quadratic in q:
///   q' = ½ q (0, ω),   I ω' = I ω × ω + tau_P + Rᵀ tau_W + Σ armᵢ × Rᵀ forceᵢ + …
/// Source: Jorba and Zou, "A software package for the numerical integration of ODEs by means of
/// high-order Taylor methods", Experimental Mathematics 14 (2005).
/// T: the scalar, double or long double.
template <class T>
class TaylorSegmentT {
 public:
  /// g_W [m/s²]: uniform gravity. start.q_WP must be a unit quaternion.
  /// horizon [s]: the longest dt that will be asked for, where it is known; a short one takes fewer
  /// terms. It promises nothing: see validFor().
  /// bound: what the error of a run may be; without one, the series hold to rounding.
  TaylorSegmentT(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                 const BodyStateT<T>& start, T horizon = std::numeric_limits<T>::infinity(),
                 const ErrorBound& bound = {});

  /// Begins anew at another start, as if made anew, under the same wrench: what does not depend on
  /// the start need not be found again.
  void startAnew(const HeldWrench& same_wrench, const BodyStateT<T>& start, T horizon);

  const BodyStateT<T>& start() const { return start_; }

  /// [s] How long after its start the series holds. Infinite where the body does not turn; NaN
  /// where the motion is not finite.
  T validFor() const { return valid_for_; }

  /// The state dt [s] after the start, 0 <= dt <= validFor(). At dt = 0 it is the start.
  ///
  /// L_W gains the time integral of the torque in world axes: for a couple fixed in the world that
  /// is tau_W dt, to the bit, and otherwise a series of its own. Turning L_P into the world instead
  /// would add the error of the attitude to L_W at every event, and break its balance with the
  /// applied torque. L_P, p_W and x_W likewise gain an increment, so that what does not change
  /// keeps its bits; the position takes it into its low part first.
  BodyStateT<T> at(T dt) const;

 protected:
  /// As far as it does not depend on a start.
  TaylorSegmentT(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                 const ErrorBound& bound);

  /// Takes a start over. rate [1/s]: at least that of what is not in the equations. Returns the
  /// rate at which the motion changes.
  T begin(const HeldWrench& wrench, const BodyStateT<T>& start, T rate);

  /// By time in the unit of the series.
  TaylorEquations<T> scaledEquations() const;
  TaylorPull<T> scaledPull() const;

  /// What a segment may err by, its motion turning by an angle.
  T precisionFor(T rate, T angle) const;

  /// How long, in time units, the last terms stay below a relative size.
  T length(T size) const;

  /// The same of one series, by the sizes of its last terms and its own.
  T lengthBy(T last, T before, T size, T own) const;

  Vector3<T> inv_I_;
  T inv_mass_;
  Vector3<T> f_P_;      // [N] force fixed in the body
  bool pulled_;         // whether forces act at points of the world
  bool body_force_;     // whether momentum gains more than f_W dt
  bool turned_;         // whether the series of products of q are there
  std::size_t degree_;  // of the series
  T rate_unit_;         // [1/s] power of two; the series are in s = rate_unit_ dt
  T valid_for_;         // [s]
  TaylorSeries<T> series_;

 private:
  void expand();
  void setUpEquations();
  void setUpPull(const HeldWrench& wrench);

  Vector3<T> pulledMoment(T s) const;
  Vector3<T> bodyDisplacement(T s, const TaylorIncrements<T>& gain) const;

  ErrorBound bound_;
  BodyStateT<T> start_;
  Vector3<T> I_;
  Vector3<T> f_W_;                // [N] constant part of the force, with gravity
  Vector3<T> a_W_;                // [m/s²] constant part of the acceleration
  Vector3<T> tau_W_;              // [N m] constant part of the torque in world axes
  Vector3<T> tau_P_;              // [N m] torque fixed in the body
  Matrix3<T> moments_;            // [N m] Σ armᵢ forceᵢᵀ, arms in P, forces in W
  bool body_torque_;              // whether angular momentum gains more than tau_W dt
  TaylorEquations<T> equations_;  // in the units of the scene
  TaylorEquations<T> scaled_;     // where nothing pulls: in the unit of time scaled_to_
  T scaled_to_ = T(0);            // [1/s] 0: in none yet
  TaylorPull<T> pull_;            // the same, where pulled_
  T equations_rate_;              // [1/s] at which they change the motion, whatever it is
};

using TaylorSegment = TaylorSegmentT<double>;

/// The state a duration [s] >= 0 later, over as many segments as it takes. Throws StepTooLong where
/// a million would not do.
template <class T>
BodyStateT<T> advanceTaylor(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                            BodyStateT<T> state, T duration, const ErrorBound& bound = {}) {
  constexpr int kMaxSegments = 1000000;
  T left = duration;
  TaylorSegmentT<T> segment(body, wrench, g_W, state, left, bound);
  for (int count = 0; count < kMaxSegments; ++count) {
    if (!(segment.validFor() < left)) return segment.at(left);
    state = segment.at(segment.validFor());
    left -= segment.validFor();
    segment.startAnew(wrench, state, left);
  }
  throw StepTooLong(
      "the motion is too fast to be followed; a shorter time_step, slower turning or less torque "
      "is needed");
}

extern template class TaylorSegmentT<double>;
extern template class TaylorSegmentT<long double>;

}  // namespace rigid_body_sim
