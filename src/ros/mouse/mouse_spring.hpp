#pragma once

#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

/// A point of a body that is pulled to a place.
struct MouseSpring {
  std::size_t body = 0;
  Vector3d point_P = Vector3d::Zero();  ///< [m] in principal axes, from the origin of P
  Vector3d goal_W = Vector3d::Zero();   ///< [m]
};

/// [kg] What a body opposes to a force at a point r, the harmonic mean over directions:
///   3 / tr(1/m − r̂ I⁻¹ r̂),   tr(−r̂ I⁻¹ r̂) = Σ (|r|² − rᵢ²) / Iᵢ.
/// On a pivot without 1/m; there, and close to it, ten times the mass of the body.
double massAtPoint(const Body& body, const Vector3d& r_P);

/// The pull on the body as it is now, for a step of h [s]: a force in world axes at the point,
///   f = m ω² (goal − x) − 2 m ω v,   m = massAtPoint,  x, v: place and velocity of the point,
/// critically damped, at ω = 10 rad/s, or 0.2/h where that is less: held over a step, the damping
/// must not overshoot in the direction in which the point is lightest, at least m/3, and
/// 2 ω h m / (m/3) = 1.2 < 2. A spring with a damper is passive: it cannot pump energy into the
/// body. Start and end of the wrench are left to the caller.
PointWrench pullOf(const MouseSpring& spring, const Body& body, const BodyState& state, double h);

}  // namespace rigid_body_sim
