#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/imu.hpp>

#include "dynamics/imu/imu_draws.hpp"
#include "math/philox.hpp"

namespace rigid_body_sim {
namespace {

/// Of the reference draws.
Imu referenceImu() {
  Imu imu;
  imu.name = "imu";
  imu.rate = 200;
  imu.seed = 1;
  return imu;
}

constexpr std::size_t kSamples = std::size_t{1} << 20;
constexpr double kRate = 200;

/// Allan deviation of values at kRate over clusters of m, that overlap.
double allanDeviation(const std::vector<double>& values, std::size_t m) {
  std::vector<double> sums{0};
  for (const double value : values) sums.push_back(sums.back() + value);
  double variance = 0;
  const std::size_t count = values.size() - 2 * m + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double change = (sums[i + 2 * m] - 2 * sums[i + m] + sums[i]) / static_cast<double>(m);
    variance += change * change;
  }
  return std::sqrt(variance / (2 * static_cast<double>(count)));
}

/// Within three sigma of what it is for an endless record.
void expectDeviations(const std::vector<double>& values, const std::vector<double>& taus,
                      const std::function<double(double)>& expected) {
  for (const double tau : taus) {
    const double ratio =
        allanDeviation(values, static_cast<std::size_t>(std::lround(tau * kRate))) / expected(tau);
    const double sigma = 0.5 * std::sqrt(3 * tau * kRate / static_cast<double>(kSamples));
    EXPECT_NEAR(ratio, 1, 3 * sigma) << tau;
  }
}

}  // namespace

TEST(ImuNoise, RefusesAnImuThatBreaksARule) {
  for (double rate : {0.0, -100.0, std::nan("")}) {
    Imu imu = referenceImu();
    imu.rate = rate;
    EXPECT_THROW(ImuNoise(imu, "body"), std::invalid_argument) << rate;
  }
}

TEST(Philox, GivesThePublishedWordsForCounterAndKeyZero) {
  const std::array<std::uint32_t, 4> words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8};
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), words);
}

TEST(Philox, GivesThePublishedWordsForTheDigitsOfPi) {
  const std::array<std::uint32_t, 4> words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1};
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            words);
}

TEST(ImuNoise, HasItsKeyFromSeedAndNames) {
  EXPECT_EQ(mixBits(0), 0xe220a8397b1dcdaf);
  EXPECT_EQ(imuKey(1, "drone", "imu"), 0xc29b90a96e07f76e);
}

TEST(ImuNoise, DrawsTheReferenceNumbers) {
  const std::uint64_t key = imuKey(1, "drone", "imu");
  const std::array<Vector3d, 5> white{
      Vector3d(-0.52786128634408969, 0.090766468795840854, 2.4103112414304371),
      Vector3d(0.057715361159485279, -1.4625938672457113, -0.8359349639775272),
      Vector3d(-0.7992342491302884, 0.0083192118172757939, -0.30283371147329047),
      Vector3d(-1.2372488560731687, 0.40049029882394066, -0.56350247809145249),
      Vector3d(0.38765869181679036, 0.63672751331478628, 0.48822129040096374)};
  for (std::size_t k = 0; k < white.size(); ++k)
    EXPECT_LT((normalDraws(key, k, kGyroscope) - white[k]).cwiseAbs().maxCoeff(), 1e-14) << k;
  const Vector3d walk(0.29534577327099809, -0.037151301170672522, 1.1775240813094747);
  EXPECT_LT((normalDraws(key, 1, kGyroscopeWalk) - walk).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(ImuNoise, IsBiasWalkAndWhiteNoise) {
  Imu imu = referenceImu();
  imu.gyroscope = {1e-2, {1, 2, 3}, 0.5};
  imu.accelerometer = {3, {-1, 0, 4}, 0};
  const ImuReading truth{{10, 20, 30}, {40, 50, 60}};
  ImuNoise noise(imu, "drone");
  const std::uint64_t key = imuKey(1, "drone", "imu");
  Vector3d walk = Vector3d::Zero();
  for (std::uint64_t k = 0; k < 6; ++k) {
    if (k > 0) walk += normalDraws(key, k, 2);
    const ImuReading reading = noise.addTo(truth, k);
    const Vector3d w = Vector3d(11, 22, 33) + 0.5 / std::sqrt(200.0) * walk +
                       1e-2 * std::sqrt(200.0) * normalDraws(key, k, 0);
    const Vector3d f = Vector3d(39, 50, 64) + 3 * std::sqrt(200.0) * normalDraws(key, k, 1);
    EXPECT_LT((reading.w_S - w).norm(), 1e-13);
    EXPECT_LT((reading.f_S - f).norm(), 1e-13);
  }
}

TEST(ImuNoise, DoesNotDependOnWhichSamplesAreAskedFor) {
  Imu imu = referenceImu();
  imu.gyroscope = {1e-4, Vector3d::Zero(), 1e-6};
  imu.accelerometer = {2e-3, Vector3d::Zero(), 3e-5};
  ImuNoise every(imu, "drone"), late(imu, "drone");
  ImuReading last;
  for (std::uint64_t k = 0; k <= 1000; ++k) last = every.addTo({}, k);
  for (const std::uint64_t k : {std::uint64_t{700}, std::uint64_t{3}, std::uint64_t{1000}}) {
    const ImuReading reading = late.addTo({}, k);
    if (k < 1000) continue;
    EXPECT_EQ(reading.w_S, last.w_S);
    EXPECT_EQ(reading.f_S, last.f_S);
  }
}

TEST(ImuNoise, IsExactWithoutNoise) {
  const ImuReading truth{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  const ImuReading reading = ImuNoise(referenceImu(), "drone").addTo(truth, 12345);
  EXPECT_EQ(reading.w_S, truth.w_S);
  EXPECT_EQ(reading.f_S, truth.f_S);
}

TEST(ImuNoise, HasTheAllanDeviationOfItsDensities) {
  Imu imu = referenceImu();
  imu.gyroscope.density = 1e-4;
  imu.accelerometer.bias_walk = 1e-2;
  ImuNoise noise(imu, "drone");
  std::vector<double> white, walk;
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const ImuReading reading = noise.addTo({}, k);
    white.push_back(reading.w_S.x());
    walk.push_back(reading.f_S.x());
  }
  expectDeviations(white, {0.01, 0.1, 1, 10}, [](double tau) { return 1e-4 / std::sqrt(tau); });
  expectDeviations(walk, {0.1, 1, 10}, [](double tau) { return 1e-2 * std::sqrt(tau / 3); });
}

}  // namespace rigid_body_sim
