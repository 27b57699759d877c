#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/math/rotation.hpp>

namespace rigid_body_sim {

/// What changes about a body, in momentum form. T: the scalar.
///
/// The angular momentum is carried twice, in world and in principal axes, because each keeps what
/// the other loses: L_W is constant to the last bit without torque; L_P gives the angular velocity
/// of a needle, whose small component would drown in the rounding of R(q_WP)ᵀ L_W.
template <class T>
struct BodyStateT {
  Vector3<T> x_W = Vector3<T>::Zero();  ///< [m] centre of mass
  Vector3<T> x_low_W =
      Vector3<T>::Zero();  ///< [m] what x_W is too coarse to hold: position = x_W + x_low_W
  Quaternion<T> q_WP = Quaternion<T>::Identity();  ///< attitude of the principal axes, unit
  Vector3<T> p_W = Vector3<T>::Zero();             ///< [kg m/s] momentum
  Vector3<T> L_W = Vector3<T>::Zero();  ///< [kg m²/s] angular momentum about the centre of mass
  Vector3<T> L_P = Vector3<T>::Zero();  ///< [kg m²/s] the same in principal axes
};
using BodyState = BodyStateT<double>;

/// What changes about the world, body by body in the order of World::bodies.
struct State {
  double t = 0;  ///< [s] since the start of the simulation
  std::vector<BodyState> bodies;
};

/// Pose and velocity of a body frame, as its user gives and reads them.
struct BodyFrameMotion {
  Vector3d x_W = Vector3d::Zero();             ///< [m] origin of B
  Quaterniond q_WB = Quaterniond::Identity();  ///< attitude of B
  Vector3d v_W = Vector3d::Zero();             ///< [m/s] velocity of the origin of B, world axes
  Vector3d w_W = Vector3d::Zero();             ///< [rad/s] angular velocity, world axes
};

/// ω = I⁻¹ L in principal axes [rad/s].
template <class T>
Vector3<T> angularVelocity(const Vector3<T>& inv_I, const Vector3<T>& L_P) {
  return inv_I.cwiseProduct(L_P);
}

/// State of the centre of mass from the motion of the body frame:
///   x = x_B + R com,  v = v_B + ω × R com,  p = m v,  L = I ω.
BodyState toBodyState(const Body& body, const BodyFrameMotion& motion);

/// The inverse of toBodyState; velocities v_B = v − ω × R com.
BodyFrameMotion toBodyFrameMotion(const Body& body, const BodyState& state);

/// [m] What rounding may do to the place of a body: where its centre of mass rests but for
/// rounding, a gap like that is no share of its path.
double positionRounding(const Body& body, const BodyState& state);

/// ½ p²/m + ½ Σ Lᵢ²/Iᵢ  [J]
double kineticEnergy(const Body& body, const BodyState& state);

}  // namespace rigid_body_sim
