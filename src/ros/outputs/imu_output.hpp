#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <sensor_msgs/Imu.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/step_sampler.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/instants.hpp"
#include "ros/outputs/output_topics.hpp"

namespace rigid_body_sim {

/// The topics <body>/<imu> and <body>/<imu>/truth: sample k of each IMU at k / rate of simulation
/// time, from the motion at that instant. Nothing is computed for an IMU without subscribers, and
/// what a sample reads does not depend on which samples were published.
class ImuOutput {
 public:
  /// The origin is referred to, not copied.
  explicit ImuOutput(const TimeOrigin& origin) : origin_(origin) {}

  /// From a time t [s] on. frame: of the sensor, on tf.
  void add(const Imu& imu, const Body& body, ImuTopics topics, std::string frame, double t);

  /// Those of a body.
  void remove(std::size_t body);

  /// [s] The next instant of an IMU that has subscribers; infinity where none has.
  double next() const;

  /// Publishes at time t [s] the samples of instants that miss it by rounding: up to `reach`, or as
  /// much before. Earlier ones that nobody has asked for are left out. Returns whether there were
  /// any to publish.
  bool publishDue(const Simulation& simulation, double t, double reach);

  /// See Outputs::takeInput.
  void takeInput();

  /// Time has been set to t [s].
  void restart(double t);

 private:
  struct Sensor {
    Imu imu;
    ImuTopics topics;
    std::string frame;
    Instants instants;
    ImuNoise noise;

    bool hasSubscribers() const {
      return topics.reading.subscribers() > 0 || topics.truth.subscribers() > 0;
    }
  };
  std::vector<BodyMotion> motionsOf(const std::vector<std::pair<Sensor*, std::uint64_t>>& due,
                                    const Simulation& simulation, double t);
  void publish(Sensor& sensor, const Body& body, const BodyMotion& motion, std::uint64_t sample);

  std::map<double, StatesWithin> within_;  // by rate
  const TimeOrigin& origin_;
  std::vector<Sensor> sensors_;
};

/// What an IMU reads, with the attitude of its own axes in the world. Covariances: those of white
/// noise, N² rate on the diagonal; zero where it has none, and for the attitude, which is exact.
/// The frame is left to the caller.
sensor_msgs::Imu toMessage(const Imu& imu, const Body& body, const BodyState& state,
                           const ImuReading& reading);

}  // namespace rigid_body_sim
