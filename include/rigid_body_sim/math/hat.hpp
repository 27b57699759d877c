#pragma once

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// The hat operator: the skew-symmetric matrix of a cross product,
///   hat(a) b = a × b,   hat(a)ᵀ = −hat(a).
/// Source: Rotenberg, "Rigid Body Motion", hat operator.
template <class T>
Matrix3<T> hat(const Vector3<T>& a) {
  Matrix3<T> a_hat;
  a_hat << T(0), -a.z(), a.y(),  //
      a.z(), T(0), -a.x(),       //
      -a.y(), a.x(), T(0);
  return a_hat;
}

/// Rate of a matrix whose columns turn with angular velocity w [rad/s], in the axes of A:
///   dA/dt = hat(w) A.
template <class T>
Matrix3<T> rotatingMatrixRate(const Vector3<T>& w, const Matrix3<T>& A) {
  return hat(w) * A;
}

/// Rate of the inertia of a body that turns with angular velocity w, both in world axes:
///   dI/dt = hat(w) I − I hat(w)   [kg m²/s],   from I = A I₀ Aᵀ and dA/dt = hat(w) A.
template <class T>
Matrix3<T> rotatingInertiaRate(const Vector3<T>& w_W, const Matrix3<T>& I_W) {
  return hat(w_W) * I_W - I_W * hat(w_W);
}

}  // namespace rigid_body_sim
