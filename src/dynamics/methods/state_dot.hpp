#pragma once

#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

/// Rate of a body's state; another type than the state, since the rate of a rotation is none.
struct BodyStateDot {
  Vector3d x_dot_W = Vector3d::Zero();              ///< [m/s]
  Eigen::Vector4d q_dot = Eigen::Vector4d::Zero();  ///< [1/s] of the coefficients x, y, z, w
  Vector3d p_dot_W = Vector3d::Zero();              ///< [N]
  Vector3d L_dot_P = Vector3d::Zero();              ///< [N m]
};

/// Newton–Euler equations in momentum form, with ω = I⁻¹ L_P:
///   x' = p/m,   q' = ½ q (0, ω),   p' = f,   L_P' = L_P × ω + τ_P
BodyStateDot stateDot(const Body& body, const BodyState& state, const Wrench& wrench);

/// sum += weight · dot
inline void accumulate(const BodyStateDot& dot, double weight, BodyStateDot& sum) {
  sum.x_dot_W += weight * dot.x_dot_W;
  sum.q_dot += weight * dot.q_dot;
  sum.p_dot_W += weight * dot.p_dot_W;
  sum.L_dot_P += weight * dot.L_dot_P;
}

/// state + h · dot, field by field; the quaternion is not unit then, and L_W is left behind. The
/// place moves in its low part, which far out is the only one to hold it.
BodyState stagePoint(const BodyState& state, const BodyStateDot& dot, double h);

/// The end of a step: as stagePoint, with position sums compensated, q unit and L_W = R L_P.
BodyState stepEnd(const BodyState& state, const BodyStateDot& dot, double h);

}  // namespace rigid_body_sim
