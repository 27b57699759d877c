#pragma once

#include "dynamics/rotation/rotation_state.hpp"

namespace rigid_body_sim {

/// Rotation at constant rate about an axis fixed in the body and in the world: a spherical body, a
/// body at rest, any body that turns exactly about a principal axis.
template <class T>
class SteadyRotation {
 public:
  /// Rate [rad/s] about the unit vector axis_P.
  SteadyRotation(const Quaternion<T>& q_WP, const Vector3<T>& L_P, const Vector3<T>& axis_P,
                 Wide<T> rate)
      : start_{q_WP, L_P}, axis_P_(axis_P), rate_(rate) {}

  RotationState<T> at(T dt) const;

 private:
  RotationState<T> start_;
  Vector3<T> axis_P_;
  Wide<T> rate_;
};

/// Body with two equal moments I_t and a third, I_k, about axis e_k: with m = L_P,
///   q(t) = q₀ exp(t m/I_t) exp(t m_k (1/I_k − 1/I_t) e_k),
/// the steady precession about L, then the steady spin about the axis of symmetry.
template <class T>
class SymmetricRotation {
 public:
  SymmetricRotation(const ScaledInertia<T>& inertia, const Quaternion<T>& q_WP,
                    const AngularMomentum<T>& L);

  RotationState<T> at(T dt) const;

 private:
  RotationState<T> start_;
  Vector3<T> direction_P_;  ///< of L at the start
  int k_;                   ///< index of the axis of symmetry
  Wide<T> precession_rate_;
  Wide<T> spin_rate_;
};

extern template class SteadyRotation<double>;
extern template class SteadyRotation<long double>;
extern template class SymmetricRotation<double>;
extern template class SymmetricRotation<long double>;

}  // namespace rigid_body_sim
