#pragma once

#include <string>

#include <rigid_body_sim/dynamics/point_wrench.hpp>

namespace rigid_body_sim {

/// Says that a wrench of finite numbers is beyond them as a whole, wherever the body is: the
/// magnitude of force or torque, or what the force turns with about the origin of the frame of its
/// point. Empty: nothing.
std::string wrenchSizeFault(const PointWrench& wrench);

}  // namespace rigid_body_sim
