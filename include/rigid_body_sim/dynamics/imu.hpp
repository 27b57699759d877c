#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <rigid_body_sim/dynamics/acceleration.hpp>

/// Inertial measurement units: a gyroscope and an accelerometer fixed to a body. See doc/imu.md.
namespace rigid_body_sim {

/// Errors of a gyroscope, in rad/s, or of an accelerometer, in m/s²; U is that unit. With all of
/// them zero the sensor is exact.
struct SensorNoise {
  double density = 0;                ///< [U/√Hz] N >= 0 of white noise
  Vector3d bias = Vector3d::Zero();  ///< [U]
  double bias_walk = 0;              ///< [U/s/√Hz] K >= 0 of the random walk of the bias
};

/// A sensor with a frame S of its own. Its sample k >= 0 is taken at the time k/rate.
struct Imu {
  std::size_t body = 0;                        ///< index
  std::string name;                            ///< not empty, unique among those of the body
  Vector3d position_B = Vector3d::Zero();      ///< [m] in the body frame
  Quaterniond q_BS = Quaterniond::Identity();  ///< its axes in the body frame, unit
  double rate = 0;                             ///< [Hz] > 0
  std::uint64_t seed = 0;                      ///< of its noise
  SensorNoise gyroscope;
  SensorNoise accelerometer;
};

/// Both in the axes of the sensor.
struct ImuReading {
  Vector3d w_S = Vector3d::Zero();  ///< [rad/s] angular velocity
  Vector3d f_S = Vector3d::Zero();  ///< [m/s²] specific force: acceleration less gravity
};

/// What an IMU without errors reads:  w = R_SB ω,  f = R_SB (a − g) at its place; see
/// specificForceOf. At rest f is 9.81 m/s² upwards (REP 145), in free fall at the centre of mass 0.
ImuReading readImu(const Imu& imu, const Body& body, const BodyMotion& motion);

/// The errors of an IMU, sample by sample:
///   reading_k = truth + bias + K √(1/rate) Σ_{j=1..k} n_j + N √rate m_k
/// n and m are independent normal draws. They depend on seed, names and sample number alone: any
/// sample may be asked for, in any order.
class ImuNoise {
 public:
  /// Throws std::invalid_argument for an IMU that breaks a rule (imuFault).
  ImuNoise(const Imu& imu, const std::string& body_name);

  /// The reading of a sample. A walk is summed up from the last sample that was asked for, at some
  /// 0.3 µs a sample, or from the start, if that was a later one.
  ImuReading addTo(const ImuReading& truth, std::uint64_t sample);

 private:
  /// One of the two sensors.
  struct Channel {
    SensorNoise noise;
    std::uint32_t stream;              // of white noise; that of the walk is two further on
    Vector3d walk = Vector3d::Zero();  // the sum of draws
  };
  Vector3d errorOf(const Channel& channel, std::uint64_t sample) const;
  void walkTo(std::uint64_t sample);

  double rate_;
  std::uint64_t key_;
  Channel gyroscope_, accelerometer_;
  std::uint64_t walked_to_ = 0;  // sample
};

/// Says which rule an IMU breaks; empty when none: rate > 0, densities >= 0, all finite, an
/// orientation of norm 1, a name.
std::string imuFault(const Imu& imu);

}  // namespace rigid_body_sim
