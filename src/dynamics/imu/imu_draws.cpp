#include "dynamics/imu/imu_draws.hpp"

#include <cmath>

#include "math/philox.hpp"
#include "math/wide.hpp"

namespace rigid_body_sim {
namespace {

std::uint64_t fnv1a(const std::string& text) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3;
  return hash;
}

std::uint32_t low(std::uint64_t z) { return static_cast<std::uint32_t>(z); }
std::uint32_t high(std::uint64_t z) { return static_cast<std::uint32_t>(z >> 32); }

/// The first 53 of 64 bits.
double bits53(std::uint32_t upper, std::uint32_t lower) {
  return static_cast<double>(((std::uint64_t{upper} << 32) | lower) >> 11);
}

/// Radius and angle of two normal draws.
struct Polar {
  double radius, angle;
};

Polar polarDraw(std::uint64_t key, std::uint64_t sample, std::uint32_t stream,
                std::uint32_t block) {
  constexpr double kUnit = 1.0 / 9007199254740992;  // 2⁻⁵³
  const auto w = philox({low(sample), high(sample), stream, block}, {low(key), high(key)});
  const double a = (bits53(w[0], w[1]) + 1) * kUnit, b = bits53(w[2], w[3]) * kUnit;
  return {std::sqrt(-2 * std::log(a)), 2 * kPi<double> * b};
}

}  // namespace

std::uint64_t mixBits(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

std::uint64_t imuKey(std::uint64_t seed, const std::string& body, const std::string& imu) {
  return mixBits(mixBits(seed) ^ fnv1a(body + "/" + imu));
}

Vector3d normalDraws(std::uint64_t key, std::uint64_t sample, std::uint32_t stream) {
  const Polar xy = polarDraw(key, sample, stream, 0), z = polarDraw(key, sample, stream, 1);
  return {xy.radius * std::cos(xy.angle), xy.radius * std::sin(xy.angle),
          z.radius * std::cos(z.angle)};
}

}  // namespace rigid_body_sim
