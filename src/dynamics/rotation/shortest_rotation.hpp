#pragma once

#include "dynamics/rotation/rotation_state.hpp"

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

/// The attitude and momentum that belong to a unit vector m of momentum: turned by psi about e_a
/// from where m lies along it, `before` that; all seen from half turned axes if `turned`.
template <class T, class Angle>
RotationState<T> turnedState(const Quaternion<T>& before, bool turned, int a, const Angle& psi,
                             const Vector3<T>& m, T magnitude) {
  const Quaternion<T> turn =
      product(rotationAbout<T>(Vector3<T>::Unit(a), psi), shortestRotation<T>(a, m));
  RotationState<T> state{product(before, turned ? halfTurned(turn) : turn), m * magnitude};
  if (turned) state.L_P = Vector3<T>(-state.L_P.x(), state.L_P.y(), -state.L_P.z());
  renormalize(state.q_WP);
  return state;
}

}  // namespace rigid_body_sim
