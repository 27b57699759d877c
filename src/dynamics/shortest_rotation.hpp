#pragma once

#include <rigid_body_sim/dynamics/rotation_state.hpp>

namespace rigid_body_sim {

/// Unit quaternion of the shortest rotation that turns m, of norm G and with m_a ≥ 0, onto e_a;
/// a = 0 or 2:
///   (c, (m × e_a)/(2 G c)),  c = √((1 + m_a/G)/2).
template <class T>
Quaternion<T> shortestRotation(int a, const Vector3<T>& m, T G) {
  using std::sqrt;
  const T c = sqrt((T(1) + m(a) / G) / T(2));
  const T scale = T(1) / (T(2) * G * c);
  if (a == 0) return Quaternion<T>(c, T(0), scale * m.z(), -scale * m.y());
  return Quaternion<T>(c, scale * m.y(), -scale * m.x(), T(0));
}

/// The same rotation, seen from axes that are turned by π about e₂.
template <class T>
Quaternion<T> halfTurned(const Quaternion<T>& q) {
  return Quaternion<T>(q.w(), -q.x(), q.y(), -q.z());
}

}  // namespace rigid_body_sim
