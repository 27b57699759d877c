#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rigid_body_sim {

/// Motion of a body frame at one instant: position (3) [m], quaternion x, y, z, w (4), velocity (3)
/// [m/s] and angular velocity (3) [rad/s], in the axes of the file.
using Motion = std::array<double, 13>;

/// Of which 0 and -0 differ.
bool haveSameBits(const Motion& a, const Motion& b);

/// Motions by time [ns]: one of an instant, or several that differ, in their order. A record holds
/// several where the state was set, the body's mass, say, while time stood.
using Motions = std::map<std::int64_t, std::vector<Motion>>;

struct RecordedMotion {
  std::map<std::string, Motions> bodies;
  std::string notice;  ///< one line, the path first; or empty
};

/// Reads the odometry in a bag, of several runs one after the other the last, or a CSV file of
/// simulate. Throws std::runtime_error with one line, the path first.
RecordedMotion readMotion(const std::string& path);

}  // namespace rigid_body_sim
