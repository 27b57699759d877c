#include "dynamics/rotation/symmetric_rotation.hpp"

namespace rigid_body_sim {

template <class T>
RotationState<T> SteadyRotation<T>::at(T dt) const {
  RotationState<T> state{product(start_.q_WP, rotationAbout<T>(axis_P_, rate_ * Wide<T>(dt))),
                         start_.L_P};
  renormalize(state.q_WP);
  return state;
}

template <class T>
SymmetricRotation<T>::SymmetricRotation(const ScaledInertia<T>& inertia, const Quaternion<T>& q_WP,
                                        const AngularMomentum<T>& L)
    : start_{q_WP, (L.direction_P * L.magnitude).template cast<T>()},
      direction_P_(L.direction_P.template cast<T>()),
      k_(inertia.I21 > Wide<T>(0) ? 0 : 2) {
  const Wide<T> rate = L.magnitude / inertia.unit;
  precession_rate_ = rate / inertia.I2;
  // 1/I_k − 1/I_t = ±I31/(I1 I3), from the difference of the moments, which is exact
  const Wide<T> sign(k_ == 0 ? 1 : -1);
  spin_rate_ = rate * L.direction_P(k_) * sign * inertia.I31 / (inertia.I1 * inertia.I3);
}

template <class T>
RotationState<T> SymmetricRotation<T>::at(T dt) const {
  const Quaternion<T> precession = rotationAbout<T>(direction_P_, precession_rate_ * Wide<T>(dt));
  const Quaternion<T> spin = rotationAbout<T>(Vector3<T>::Unit(k_), spin_rate_ * Wide<T>(dt));
  RotationState<T> state{product(start_.q_WP, product(precession, spin)),
                         rotateBack(spin, start_.L_P)};
  renormalize(state.q_WP);
  return state;
}

template class SteadyRotation<double>;
template class SteadyRotation<long double>;
template class SymmetricRotation<double>;
template class SymmetricRotation<long double>;

}  // namespace rigid_body_sim
