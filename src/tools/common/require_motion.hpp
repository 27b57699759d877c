#pragma once

#include <array>

namespace rigid_body_sim {

/// position, quaternion x, y, z, w, velocity and angular velocity, of which none may be infinite or
/// no number, and the quaternion must be a unit one. Throws std::runtime_error with one line.
void requireMotion(const std::array<double, 13>& motion);

}  // namespace rigid_body_sim
