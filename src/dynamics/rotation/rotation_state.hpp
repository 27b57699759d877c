#pragma once

#include <cmath>

#include <rigid_body_sim/math/rotation.hpp>

#include "math/wide.hpp"

namespace rigid_body_sim {

/// What changes in a free rotation.
template <class T>
struct RotationState {
  Quaternion<T> q_WP;  ///< attitude of the principal axes, unit
  Vector3<T> L_P;      ///< [kg m²/s] angular momentum in principal axes
};

/// Principal moments in units of the greatest one, and their differences, each correct to the wide
/// scalar's rounding however close the moments are.
template <class T>
struct ScaledInertia {
  explicit ScaledInertia(const Vector3<T>& I);

  Wide<T> unit;           ///< [kg m²] the greatest moment
  Wide<T> I1, I2, I3;     ///< ascending, I3 = 1
  Wide<T> I21, I31, I32;  ///< I2 − I1, I3 − I1, I3 − I2
};

/// The constant of a free motion, from its two accounts: the magnitude from the world's, which is
/// constant to the last bit; the direction from the body's, which keeps the digits of a needle's
/// small component. (The magnitude of L_P is off by a unit of rounding after every anchor, always
/// the same way: over 1e5 anchors that costs 1e-8 rad where L_W's costs 1e-12.)
template <class T>
struct AngularMomentum {
  AngularMomentum(const Vector3<T>& L_P, const Vector3<T>& L_W);

  Wide<T> magnitude;             ///< [kg m²/s]
  Vector3<Wide<T>> direction_P;  ///< unit; zero for a body at rest
};

/// Quaternion of the rotation by angle [rad] about a principal axis or a unit vector. The angle is
/// reduced in the wide scalar: thousands of turns cost no digits.
template <class T>
Quaternion<T> rotationAbout(const Vector3<T>& axis, Wide<T> angle) {
  using std::cos;
  using std::rint;
  using std::sin;
  constexpr Wide<T> kTwoPi = Wide<T>(2) * kPi<Wide<T>>;
  Wide<T> half = angle / Wide<T>(2);
  if (!(half < kPi<Wide<T>> && half > -kPi<Wide<T>>)) half -= kTwoPi * rint(half / kTwoPi);
  const T s = sin(T(half));
  return Quaternion<T>(cos(T(half)), s * axis.x(), s * axis.y(), s * axis.z());
}

}  // namespace rigid_body_sim
