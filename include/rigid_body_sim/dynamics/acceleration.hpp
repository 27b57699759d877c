#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

/// The centre of a gravitational field  g(x) = −mu (x − center)/|x − center|³.
struct GravityCenter {
  Vector3d center_W = Vector3d::Zero();  ///< [m]
  double mu = 0;                         ///< [m³/s²] > 0
};

/// How a body accelerates at an instant, from the forces and torques that act on it, motors
/// included. Where one of them starts or ends at that instant, it is what holds after it.
///
/// Gravity is kept apart, since an accelerometer does not read it: the acceleration of the centre
/// of mass is felt_W + g_W. A body in free fall has felt_W = 0, exactly.
///
/// Of a body on a pivot, felt_W + g_W is the acceleration of the pivot, which is zero.
struct BodyAcceleration {
  Vector3d felt_W = Vector3d::Zero();  ///< [m/s²] all forces but gravity, over the mass
  Vector3d g_W = Vector3d::Zero();  ///< [m/s²] uniform and central gravity; of a fixed body −felt
  Vector3d w_dot_P = Vector3d::Zero();   ///< [rad/s²] angular acceleration, principal axes
  std::vector<GravityCenter> centers{};  ///< of the central gravity that acts on the body
  /// [N] On a body on a pivot: all forces but that of the pivot, gravity included. Else zero.
  Vector3d on_pivoted_W = Vector3d::Zero();
};

/// The state of a body at an instant, and how it accelerates then.
struct BodyMotion {
  BodyState state;
  BodyAcceleration acceleration;
};

/// [m/s²] Acceleration of a point of the body, in world axes. point_P [m]: in principal axes, from
/// the origin of P.
///   a = felt + g + R (ω' × r + ω × (ω × r))
Vector3d accelerationOf(const Body& body, const BodyMotion& motion, const Vector3d& point_P);

/// [m/s²] What an accelerometer at a point of the body would read, in principal axes: the
/// acceleration of the point less gravity at the point. point_P [m]: as above.
///   f = Rᵀ (felt + g(x_c) − g(x)) + ω' × r + ω × (ω × r)
/// The difference of gravity is zero for uniform gravity, and for central gravity it is computed
/// without cancellation (Encke's method; Battin, "An Introduction to the Mathematics and Methods of
/// Astrodynamics", section 8.4). For a fixed body f = −Rᵀ g(x); on a pivot f = −Rᵀ g(x) + ω' × r +
/// ω × (ω × r).
Vector3d specificForceOf(const Body& body, const BodyMotion& motion, const Vector3d& point_P);

/// [N] The force that its pivot exerts on a body, world axes: with a_c the acceleration of the
/// centre of mass and Σ f all other forces, gravity included,
///   m a_c − Σ f.
/// Zero for a body without a pivot. Without friction the pivot exerts no torque.
Vector3d pivotForceOf(const Body& body, const BodyMotion& motion);

}  // namespace rigid_body_sim
