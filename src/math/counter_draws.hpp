#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include "math/fnv1a.hpp"
#include "math/philox.hpp"
#include "math/wide.hpp"

namespace rigid_body_sim {

/// Random draws without a state: each depends on a key and on its counters alone, so that it does
/// not matter who draws what, when, or in which order.

/// One step of SplitMix64: a hash of 64 bits to 64.
inline std::uint64_t mixBits(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

/// The key of what is drawn for a name: mix(mix(seed) ^ FNV-1a-64(name)).
inline std::uint64_t drawKey(std::uint64_t seed, std::string_view name) {
  Fnv1a hash;
  hash.add(name);
  return mixBits(mixBits(seed) ^ hash.hash());
}

/// Two independent draws, uniform over (0, 1] and [0, 1), by the words w of Philox at the counter
/// (sample, stream, block):
///   above_zero = ((w₀ 2³² + w₁) >> 11 + 1) 2⁻⁵³,  below_one = ((w₂ 2³² + w₃) >> 11) 2⁻⁵³
struct UniformDraws {
  double above_zero, below_one;
};

inline UniformDraws uniformDraws(std::uint64_t key, std::uint64_t sample, std::uint32_t stream,
                                 std::uint32_t block) {
  const auto low = [](std::uint64_t z) { return static_cast<std::uint32_t>(z); };
  const auto high = [](std::uint64_t z) { return static_cast<std::uint32_t>(z >> 32); };
  const auto bits53 = [](std::uint32_t upper, std::uint32_t lower) {
    return static_cast<double>(((std::uint64_t{upper} << 32) | lower) >> 11);
  };
  constexpr double kUnit = 1.0 / 9007199254740992;  // 2⁻⁵³
  const auto w = philox({low(sample), high(sample), stream, block}, {low(key), high(key)});
  return {(bits53(w[0], w[1]) + 1) * kUnit, bits53(w[2], w[3]) * kUnit};
}

/// Radius and angle of two independent normal draws of mean 0 and variance 1, radius cos(angle) and
/// radius sin(angle), by Box and Muller's method: √(−2 ln a), 2πb.
struct PolarDraw {
  double radius, angle;
};

inline PolarDraw polarDraw(const UniformDraws& u) {
  return {std::sqrt(-2 * std::log(u.above_zero)), 2 * kPi<double> * u.below_one};
}

}  // namespace rigid_body_sim
