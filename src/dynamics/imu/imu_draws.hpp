#pragma once

#include <cstdint>
#include <string>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// One step of SplitMix64: a hash of 64 bits to 64.
std::uint64_t mixBits(std::uint64_t z);

/// The key of an IMU's draws: mix(mix(seed) ^ FNV-1a("<body>/<imu>")).
std::uint64_t imuKey(std::uint64_t seed, const std::string& body, const std::string& imu);

/// Streams of draws of one IMU.
enum ImuStream : std::uint32_t {
  kGyroscope = 0,
  kAccelerometer = 1,
  kGyroscopeWalk = 2,
  kAccelerometerWalk = 3
};

/// Three independent draws from the normal distribution, of mean 0 and variance 1, by Box and
/// Muller's method from the words w of Philox at the counter (sample, stream, block):
///   a = ((w₀ 2³² + w₁) >> 11 + 1) 2⁻⁵³,  b = ((w₂ 2³² + w₃) >> 11) 2⁻⁵³,
///   √(−2 ln a) (cos 2πb, sin 2πb)
/// Block 0 gives x and y, block 1 gives z.
Vector3d normalDraws(std::uint64_t key, std::uint64_t sample, std::uint32_t stream);

}  // namespace rigid_body_sim
