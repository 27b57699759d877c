#include "dynamics/rotation/asymmetric_rotation.hpp"
#include "dynamics/rotation/shortest_rotation.hpp"

namespace rigid_body_sim {

template <class T>
SeparatrixRotation<T>::SeparatrixRotation(const ScaledInertia<T>& inertia,
                                          const FreeInvariants<T>& invariants,
                                          const Quaternion<T>& q_WP)
    : magnitude_(invariants.magnitude) {
  using std::asinh;
  using std::sqrt;
  using W = Wide<T>;
  const Vector3<W>& m = invariants.m;
  const W A1 = sqrt(-inertia.I1 * invariants.D3 / inertia.I31);
  const W A3 = sqrt(inertia.I3 * invariants.D1 / inertia.I31);
  amplitude_1_ = T(A1);
  amplitude_3_ = T(A3);
  a_ = A1 < A3 ? 0 : 2;
  turned_ = m(a_) < W(0);
  other_sign_ = T((m(2 - a_) < W(0)) == turned_ ? 1 : -1);
  sigma_ = other_sign_ * T(a_ == 0 ? -1 : 1);
  lambda_ = W(other_sign_) * invariants.rate *
            sqrt(-invariants.D1 * invariants.D3 / (inertia.I1 * inertia.I3));
  rate_ = invariants.rate / inertia.I2;
  u0_ = T(asinh(m(1) / sqrt(m(0) * m(0) + m(2) * m(2))));
  const Quaternion<T> back(shortestRotation<T>(a_, momentum(u0_)).conjugate());
  before_ = product(q_WP, turned_ ? halfTurned(back) : back);
}

template <class T>
Vector3<T> SeparatrixRotation<T>::momentum(T u) const {
  using std::cosh;
  using std::tanh;
  const T sech = T(1) / cosh(u);
  Vector3<T> m(amplitude_1_ * sech, tanh(u), amplitude_3_ * sech);
  m(2 - a_) *= other_sign_;
  return m;
}

template <class T>
T SeparatrixRotation<T>::angle(T u) const {
  using std::atan2;
  using std::tanh;
  const T x = a_ == 0 ? amplitude_1_ : amplitude_3_;
  const T y = a_ == 0 ? amplitude_3_ : amplitude_1_;
  return T(2) * sigma_ * atan2((x - T(1)) * tanh(u / T(2)), y);
}

template <class T>
RotationState<T> SeparatrixRotation<T>::at(T dt) const {
  using W = Wide<T>;
  const T u = T(W(u0_) + lambda_ * W(dt));
  const W psi = rate_ * W(dt) + W(angle(u) - angle(u0_));
  const Vector3<T> m = momentum(u);
  return turnedState<T>(before_, turned_, a_, psi, m, magnitude_);
}

template class SeparatrixRotation<double>;
template class SeparatrixRotation<long double>;

}  // namespace rigid_body_sim
