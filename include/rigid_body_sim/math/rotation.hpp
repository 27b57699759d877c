#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// |v| of a finite v without overflow or underflow between: m |v/m| with the largest component m.
template <class T>
T stableNorm(const Vector3<T>& v) {
  using std::abs;
  using std::sqrt;
  const T largest = std::max({abs(v.x()), abs(v.y()), abs(v.z())});
  if (!(largest > T(0))) return abs(v.x()) + abs(v.y()) + abs(v.z());  // zero, or not a number
  T scale = largest, inverse = T(1) / largest;
  if (inverse > std::numeric_limits<T>::max()) {
    inverse = std::numeric_limits<T>::max();
    scale = T(1) / inverse;
  }
  const T x = v.x() * inverse, y = v.y() * inverse, z = v.z() * inverse;
  return scale * sqrt(x * x + y * y + z * z);
}

/// Unit quaternion of the rotation by |theta| [rad] about theta:
///   (cos(|theta|/2), sin(|theta|/2) theta/|theta|).
/// Relative error of a few ulp for every finite theta; identity at zero.
template <class T>
Quaternion<T> rotationExp(const Vector3<T>& theta) {
  using std::cos;
  using std::sin;
  const T angle = stableNorm(theta);
  if (!(angle > T(0))) return Quaternion<T>::Identity();
  const T half = angle / T(2);
  const T s = sin(half) / angle;
  return Quaternion<T>(cos(half), s * theta.x(), s * theta.y(), s * theta.z());
}

/// Product of two quaternions a b, Hamilton's convention; written out, so that it is the same
/// arithmetic for every scalar and every compiler. T follows from a alone, here and in
/// angleBetween, so that b may be what Eigen returns, such as Identity().
template <class T>
Quaternion<T> product(const Quaternion<T>& a, const std::common_type_t<Quaternion<T>>& b) {
  return Quaternion<T>(a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
                       a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
                       a.w() * b.y() - a.x() * b.z() + a.y() * b.w() + a.z() * b.x(),
                       a.w() * b.z() + a.x() * b.y() - a.y() * b.x() + a.z() * b.w());
}

/// v_W = R(q_WB) v_B for a unit quaternion:  v + 2 u × (u × v + w v),  u the vector part.
template <class T>
Vector3<T> rotate(const Quaternion<T>& q, const Vector3<T>& v) {
  const Vector3<T> u = q.vec();
  const Vector3<T> t = T(2) * u.cross(v);
  return v + q.w() * t + u.cross(t);
}

/// v_B = R(q_WB)ᵀ v_W for a unit quaternion.
template <class T>
Vector3<T> rotateBack(const Quaternion<T>& q, const Vector3<T>& v) {
  const Vector3<T> u = q.vec();
  const Vector3<T> t = T(2) * u.cross(v);
  return v - q.w() * t + u.cross(t);
}

/// Whether a quaternion that was written down or sent stands for a rotation: its norm is off 1 by
/// no more than 1e-3. The margin is a few roundings of the norm: 1 − 0.999 comes out above 0.001.
inline bool isNearlyUnit(const Quaterniond& q) {
  constexpr double kMargin = 1e-15;
  const double norm = std::hypot(std::hypot(q.x(), q.y(), q.z()), q.w());
  return std::abs(norm - 1) <= 1e-3 + kMargin;
}

/// A quaternion whose norm is off 1 by e comes back off by 3e²/2: one Newton step of 1/sqrt,
/// without a root or a division.
template <class T>
void renormalize(Quaternion<T>& q) {
  q.coeffs() *= (T(3) - q.squaredNorm()) / T(2);
}

/// Angle [rad], 0 … π, of the rotation that takes attitude a to attitude b:
///   2 atan2(|vec(a⁻¹ b)|, |scalar(a⁻¹ b)|);
/// full relative accuracy down to zero, where an arc cosine has lost every digit.
template <class T>
T angleBetween(const Quaternion<T>& a, const std::common_type_t<Quaternion<T>>& b) {
  using std::abs;
  using std::atan2;
  const Quaternion<T> d = product(Quaternion<T>(a.conjugate()), b);
  return T(2) * atan2(d.vec().norm(), abs(d.w()));
}

}  // namespace rigid_body_sim
