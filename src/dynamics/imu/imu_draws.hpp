#pragma once

#include <cstdint>
#include <string>

#include <rigid_body_sim/math/types.hpp>

#include "math/counter_draws.hpp"

namespace rigid_body_sim {

/// The key of an IMU's draws: mix(mix(seed) ^ FNV-1a("<body>/<imu>")).
std::uint64_t imuKey(std::uint64_t seed, const std::string& body, const std::string& imu);

/// Streams of draws of one IMU.
enum ImuStream : std::uint32_t {
  kGyroscope = 0,
  kAccelerometer = 1,
  kGyroscopeWalk = 2,
  kAccelerometerWalk = 3
};

/// Three independent draws from the normal distribution, of mean 0 and variance 1: x and y of
/// polarDraw at the counter (sample, stream, block 0), z the first of block 1.
Vector3d normalDraws(std::uint64_t key, std::uint64_t sample, std::uint32_t stream);

}  // namespace rigid_body_sim
