#pragma once

#include <rigid_body_sim/dynamics/rotation_state.hpp>

namespace rigid_body_sim {

/// Unit quaternion of the shortest rotation that turns the unit vector m, with m_a ≥ 0, onto e_a;
/// a = 0 or 2:
///   (c, (m × e_a)/(2 c)),  c = √((1 + m_a)/2).
template <class T>
Quaternion<T> shortestRotation(int a, const Vector3<T>& m) {
  using std::sqrt;
  const T c = sqrt((T(1) + m(a)) / T(2));
  const T scale = T(1) / (T(2) * c);
  if (a == 0) return Quaternion<T>(c, T(0), scale * m.z(), -scale * m.y());
  return Quaternion<T>(c, scale * m.y(), -scale * m.x(), T(0));
}

/// The same rotation, seen from axes that are turned by π about e₂.
template <class T>
Quaternion<T> halfTurned(const Quaternion<T>& q) {
  return Quaternion<T>(q.w(), -q.x(), q.y(), -q.z());
}

}  // namespace rigid_body_sim
