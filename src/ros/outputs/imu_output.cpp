#include "ros/outputs/imu_output.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <boost/array.hpp>

#include <rigid_body_sim/dynamics/contact_point.hpp>

namespace rigid_body_sim {
namespace {

boost::array<double, 9> covarianceOf(const SensorNoise& noise, double rate) {
  boost::array<double, 9> covariance{};
  covariance[0] = covariance[4] = covariance[8] = noise.density * noise.density * rate;
  return covariance;
}

/// The same IMU without errors.
Imu exact(Imu imu) {
  imu.gyroscope = imu.accelerometer = SensorNoise();
  return imu;
}

}  // namespace

sensor_msgs::Imu toMessage(const Imu& imu, const Body& body, const BodyState& state,
                           const ImuReading& reading) {
  const Quaterniond q_WB = product(state.q_WP, body.q_BP.conjugate());
  sensor_msgs::Imu message;
  message.orientation = toQuaternion(product(q_WB, imu.q_BS));
  message.angular_velocity = toVector3(reading.w_S);
  message.angular_velocity_covariance = covarianceOf(imu.gyroscope, imu.rate);
  message.linear_acceleration = toVector3(reading.f_S);
  message.linear_acceleration_covariance = covarianceOf(imu.accelerometer, imu.rate);
  return message;
}

void ImuOutput::add(const Imu& imu, const Body& body, ImuTopics topics, std::string frame,
                    double t) {
  sensors_.push_back(
      {imu, std::move(topics), std::move(frame), Instants(imu.rate, t), ImuNoise(imu, body.name)});
}

void ImuOutput::remove(std::size_t body) {
  sensors_.erase(std::remove_if(sensors_.begin(), sensors_.end(),
                                [body](const Sensor& sensor) { return sensor.imu.body == body; }),
                 sensors_.end());
}

double ImuOutput::next() const {
  double next = std::numeric_limits<double>::infinity();
  for (const Sensor& sensor : sensors_)
    if (sensor.instants.next() < next && sensor.hasSubscribers()) next = sensor.instants.next();
  return next;
}

bool ImuOutput::publishDue(const Simulation& simulation, double t, double reach) {
  const double from = t - (reach - t);
  std::vector<std::pair<Sensor*, std::uint64_t>> due;
  for (Sensor& sensor : sensors_) {
    const std::optional<std::uint64_t> sample = sensor.instants.take(from, reach);
    if (!sample || !sensor.hasSubscribers()) continue;
    if (simulation.world().bodies[sensor.imu.body].absent) continue;
    due.emplace_back(&sensor, *sample);
  }
  if (due.empty()) return false;
  const std::vector<BodyMotion> motions = motionsOf(due, simulation, t);
  for (std::size_t i = 0; i < due.size(); ++i) {
    const auto& [sensor, sample] = due[i];
    publish(*sensor, simulation.world().bodies[sensor->imu.body], motions[i], sample);
  }
  return true;
}

/// Within a step with contact or tethers those of one rate go on from one another; else all at
/// once: bodies that act on one another share the work.
std::vector<BodyMotion> ImuOutput::motionsOf(
    const std::vector<std::pair<Sensor*, std::uint64_t>>& due, const Simulation& simulation,
    double t) {
  std::vector<BodyMotion> motions;
  std::vector<std::size_t> bodies;
  const bool goes_on = t > simulation.time() && hasOneSidedLaw(simulation.world());
  for (const auto& [sensor, sample] : due) {
    const std::size_t body = sensor->imu.body;
    bodies.push_back(body);
    if (!goes_on) continue;
    const double rate = sensor->imu.rate;
    StatesWithin& within = within_.try_emplace(rate, rate).first->second;
    motions.push_back(within.motions(simulation, {body}, t)[0]);
  }
  return goes_on ? motions : simulation.motions(bodies, t);
}

void ImuOutput::takeInput() {
  for (auto& [rate, within] : within_) within.restart();
}

void ImuOutput::publish(Sensor& sensor, const Body& body, const BodyMotion& motion,
                        std::uint64_t sample) {
  const ros::Time stamp = origin_.stamp(static_cast<double>(sample) / sensor.imu.rate);
  const ImuReading truth = readImu(sensor.imu, body, motion);
  const auto send = [&](const Topic<sensor_msgs::Imu>& topic, sensor_msgs::Imu message) {
    message.header.frame_id = sensor.frame;
    message.header.stamp = stamp;
    topic.publish(message, stamp);
  };
  if (sensor.topics.reading.subscribers())
    send(sensor.topics.reading,
         toMessage(sensor.imu, body, motion.state, sensor.noise.addTo(truth, sample)));
  if (sensor.topics.truth.subscribers())
    send(sensor.topics.truth, toMessage(exact(sensor.imu), body, motion.state, truth));
}

void ImuOutput::restart(double t) {
  for (Sensor& sensor : sensors_) sensor.instants.restart(t);
}

}  // namespace rigid_body_sim
