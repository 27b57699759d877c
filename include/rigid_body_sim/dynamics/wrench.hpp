#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/point_wrench.hpp>
#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

/// Force and torque on a body, about the origin of P: its centre of mass, or its pivot. The torque
/// is the sum of two parts, each in the axes in which it arises: turning a body's own torque to the
/// world and back would cost a needle the digits of its small component.
///   total torque = tau_W + R(q_WP) tau_P
struct Wrench {
  Vector3d f_W = Vector3d::Zero();    ///< [N]
  Vector3d tau_W = Vector3d::Zero();  ///< [N m] world axes
  Vector3d tau_P = Vector3d::Zero();  ///< [N m] principal axes
};

/// Adds the force f_W [N] that acts at the world point r_W [m]:  f += f_W,  τ += (r − x) × f_W.
/// Source: Rotenberg, "Rigid Body Motion", ApplyForce.
void applyForce(Wrench& wrench, const BodyState& state, const Vector3d& f_W, const Vector3d& r_W);

/// Relative change of a wrench's duration, by the rounding of its start and end, up to which force
/// × duration is left alone: far above what rounding does to wrenches of some steps, and far below
/// what shows. Beyond, the force makes up for it.
constexpr double kImpulseRounding = 1e-12;

/// The vector v, a force or torque of an applied wrench, from the axes of the wrench to the
/// world's.
Vector3d toWorldAxes(const PointWrench& applied, const Vector3d& v,
                     const std::vector<BodyState>& bodies);

/// [m] From the origin of P of the body acted on to the point at which the force acts, world axes.
Vector3d armOf(const PointWrench& applied, const std::vector<BodyState>& bodies);

/// Adds an applied wrench at the given states of all bodies.
void addPointWrench(const PointWrench& applied, const std::vector<BodyState>& bodies,
                    Wrench& wrench);

}  // namespace rigid_body_sim
