#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace rigid_body_sim {

/// Motion of a body frame at one instant: position (3) [m], quaternion x, y, z, w (4), velocity (3)
/// [m/s] and angular velocity (3) [rad/s], in the axes of the file.
using Motion = std::array<double, 13>;

/// Motions by time [ns], by body.
using RecordedMotion = std::map<std::string, std::map<std::int64_t, Motion>>;

/// Reads the odometry in a bag, or a CSV file of simulate. Throws std::runtime_error with one line,
/// the path first.
RecordedMotion readMotion(const std::string& path);

}  // namespace rigid_body_sim
