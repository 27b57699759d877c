#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/dynamics/wrench.hpp>

/// Wrenches from the frames that a user of the library knows. The simulation holds axes and points
/// that move with a body in its principal frame P; these functions convert from the body frame B.
///
/// `body` is an index of `bodies`, which are those of the world. Force and torque keep their axes
/// while they act, from time zero on, or from `start` to `end` of what is returned. Each function
/// throws std::invalid_argument for an index out of range, a fixed body and numbers that are not
/// finite.
namespace rigid_body_sim {

/// A thruster: force [N] and torque [N m] in axes of B, the force at a point [m] of B; all turn and
/// move with the body.
PointWrench wrenchInBodyAxes(const std::vector<Body>& bodies, std::size_t body,
                             const Vector3d& force_B, const Vector3d& torque_B,
                             const Vector3d& point_B);

/// A pull along a line that keeps its direction, as of a far tug: force [N] and torque [N m] in
/// world axes, the force at a point [m] of B, which moves with the body.
PointWrench wrenchInWorldAxes(const std::vector<Body>& bodies, std::size_t body,
                              const Vector3d& force_W, const Vector3d& torque_W,
                              const Vector3d& point_B);

/// Force [N] and torque [N m] in world axes, the force at the centre of mass, wherever that
/// is when mass properties are set.
PointWrench wrenchAtCenterOfMass(const std::vector<Body>& bodies, std::size_t body,
                                 const Vector3d& force_W, const Vector3d& torque_W);

}  // namespace rigid_body_sim
