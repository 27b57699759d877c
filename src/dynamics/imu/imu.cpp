#include <cmath>

#include <rigid_body_sim/dynamics/imu.hpp>

#include "dynamics/imu/imu_draws.hpp"
#include "dynamics/require.hpp"
#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

std::string noiseFault(const std::string& sensor, const SensorNoise& noise) {
  const auto isDensity = [](double x) { return x >= 0 && std::isfinite(x); };
  if (!isDensity(noise.density))
    return sensor + " noise density must be >= 0, got " + shortest(noise.density);
  if (!isDensity(noise.bias_walk))
    return sensor + " bias walk must be >= 0, got " + shortest(noise.bias_walk);
  return noise.bias.allFinite() ? "" : sensor + " bias must be finite";
}

}  // namespace

ImuReading readImu(const Imu& imu, const Body& body, const BodyMotion& motion) {
  const Vector3d point_P = body.X_BP.inverse() * imu.position_B;
  const Vector3d w_P = angularVelocity(body.inv_I, motion.state.L_P);
  const auto toSensor = [&](const Vector3d& v_P) {
    return rotateBack(imu.q_BS, rotate(body.q_BP, v_P));
  };
  return {toSensor(w_P), toSensor(specificForceOf(body, motion, point_P))};
}

ImuNoise::ImuNoise(const Imu& imu, const std::string& body_name)
    : rate_(imu.rate),
      key_(imuKey(imu.seed, body_name, imu.name)),
      gyroscope_{imu.gyroscope, kGyroscope},
      accelerometer_{imu.accelerometer, kAccelerometer} {
  const std::string fault = imuFault(imu);
  require(fault.empty(), "body '", body_name, "': ", fault);
}

ImuReading ImuNoise::addTo(const ImuReading& truth, std::uint64_t sample) {
  walkTo(sample);
  return {truth.w_S + errorOf(gyroscope_, sample), truth.f_S + errorOf(accelerometer_, sample)};
}

void ImuNoise::walkTo(std::uint64_t sample) {
  if (sample < walked_to_) {
    gyroscope_.walk = accelerometer_.walk = Vector3d::Zero();
    walked_to_ = 0;
  }
  const bool w_walks = gyroscope_.noise.bias_walk > 0, f_walks = accelerometer_.noise.bias_walk > 0;
  if (w_walks || f_walks)
    for (std::uint64_t j = walked_to_ + 1; j <= sample; ++j) {
      if (w_walks) gyroscope_.walk += normalDraws(key_, j, kGyroscopeWalk);
      if (f_walks) accelerometer_.walk += normalDraws(key_, j, kAccelerometerWalk);
    }
  walked_to_ = sample;
}

Vector3d ImuNoise::errorOf(const Channel& channel, std::uint64_t sample) const {
  const SensorNoise& noise = channel.noise;
  Vector3d error = noise.bias;
  if (noise.bias_walk > 0) error += noise.bias_walk * std::sqrt(1 / rate_) * channel.walk;
  if (noise.density > 0)
    error += noise.density * std::sqrt(rate_) * normalDraws(key_, sample, channel.stream);
  return error;
}

std::string imuFault(const Imu& imu) {
  if (imu.name.empty()) return "an IMU must have a name";
  const std::string who = "IMU '" + imu.name + "': ";
  if (!(imu.rate > 0 && std::isfinite(imu.rate)))
    return who + "rate must be > 0 Hz, got " + shortest(imu.rate);
  if (!imu.position_B.allFinite()) return who + "position must be finite";
  if (!(std::abs(imu.q_BS.norm() - 1) < 1e-6)) return who + "orientation must be of norm 1";
  for (const std::string& fault : {noiseFault(who + "gyroscope", imu.gyroscope),
                                   noiseFault(who + "accelerometer", imu.accelerometer)})
    if (!fault.empty()) return fault;
  return "";
}

}  // namespace rigid_body_sim
