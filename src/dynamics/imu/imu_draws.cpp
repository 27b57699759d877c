#include "dynamics/imu/imu_draws.hpp"

#include <cmath>

namespace rigid_body_sim {

std::uint64_t imuKey(std::uint64_t seed, const std::string& body, const std::string& imu) {
  return drawKey(seed, body + "/" + imu);
}

Vector3d normalDraws(std::uint64_t key, std::uint64_t sample, std::uint32_t stream) {
  const PolarDraw xy = polarDraw(uniformDraws(key, sample, stream, 0)),
                  z = polarDraw(uniformDraws(key, sample, stream, 1));
  return {xy.radius * std::cos(xy.angle), xy.radius * std::sin(xy.angle),
          z.radius * std::cos(z.angle)};
}

}  // namespace rigid_body_sim
