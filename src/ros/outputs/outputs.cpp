#include "ros/outputs/outputs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigid_body_sim/math/isometry.hpp>

#include "ros/outputs/law_forces.hpp"
#include "ros/outputs/markers.hpp"
#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {
namespace {

/// Arrows and trails are for the eye [1/s of simulation time].
constexpr double kMarkerRate = 30;

boost::array<double, 36> diagonalMatrix(const std::array<double, 6>& diagonal) {
  boost::array<double, 36> matrix{};
  for (std::size_t i = 0; i < 6; ++i) matrix[7 * i] = diagonal[i];
  return matrix;
}

}  // namespace

Outputs::Outputs(OutputTopics topics, const NodeOptions& options, const Scene& scene,
                 const Simulation& simulation, const TimeOrigin& origin)
    : topics_(std::move(topics)),
      simulation_(&simulation),
      origin_(origin),
      world_frame_(scene.world_frame),
      frames_(scene, options.tf_prefix),
      covariance_(diagonalMatrix(options.odometry_covariance)),
      publish_clock_(options.publish_clock),
      state_instants_(options.publish_rate, simulation.time()),
      clock_instants_(options.clock_rate, simulation.time()),
      marker_instants_(std::min(options.publish_rate, kMarkerRate), simulation.time()),
      contacts_(topics_.contacts, scene.world_frame, origin),
      imus_(origin),
      live_markers_(topics_.live_markers, scene.world_frame, frames_.bodies()),
      all_bodies_(toMarkers(scene, frames_)),
      bodies_(all_bodies_),
      absent_(simulation.world().bodies.size()) {
  std::vector<std::optional<BodyTopics>> of_body(simulation.world().bodies.size());
  for (BodyTopics& own : std::exchange(topics_.bodies, {})) of_body[own.body] = std::move(own);
  for (std::size_t i = 0; i < of_body.size(); ++i) take(i, std::move(of_body[i]));
  listBodies();
  bodies_ = presentMarkers();
  publishOnce(scene);
  greet();
}

void Outputs::publishOnce(const Scene& scene) {
  const ros::Time stamp = origin_.stamp(simulation_->time());
  const std::vector<Body>& bodies = simulation_->world().bodies;
  tf2_msgs::TFMessage frames;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].fixed)
      frames.transforms.push_back(
          toTransform(bodies[i], simulation_->body(i), world_frame_, frames_.of(i), stamp));
    for (const PointDef& point : scene.bodies[i].points)
      frames.transforms.push_back(toTransform(isometry(point.orientation, point.position),
                                              frames_.of(i), frames_.of(i, point.name), stamp));
    for (const ImuDef& def : scene.bodies[i].imus)
      frames.transforms.push_back(toTransform(isometry(def.imu.q_BS, def.imu.position_B),
                                              frames_.of(i), frames_.of(i, def.imu.name), stamp));
  }
  if (!frames.transforms.empty()) topics_.tf_static.publish(frames, stamp);
  topics_.markers.publish(bodies_, stamp);
}

/// What is sent to a subscriber that comes while time stands: to it alone, so that every subscriber
/// receives strictly increasing stamps on /tf.
template <class ToMessage>
auto Outputs::greeting(ToMessage toMessage, std::optional<std::size_t> body) {
  return [this, toMessage, body]() {
    using Message = decltype(toMessage(shown(), ros::Time()));
    if (!standing_ || (body && isAbsent(*body))) return std::optional<Message>();
    const Snapshot snapshot = shown();
    return std::optional<Message>(toMessage(snapshot, origin_.stamp(snapshot.time())));
  };
}

void Outputs::greet() {
  topics_.tf.greetWith(greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    greeted_ = stamp;
    return toTransforms(snapshot, stamp);
  }));
  topics_.states.greetWith(greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    setStates(snapshot, stamp);
    return states_;
  }));
  contacts_.greetWith(greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    return contacts_.standing(snapshot, stamp);
  }));
  if (!topics_.law_forces.greetWith) return;
  topics_.law_forces.greetWith(greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    return toLawForces(snapshot, world_frame_, stamp);
  }));
}

void Outputs::greet(const BodyTopics& topics) {
  const std::size_t body = topics.body;
  topics.odometry.greetWith(
      greeting([=](const Snapshot& snapshot,
                   const ros::Time& stamp) { return toOdometry(body, snapshot, stamp); },
               body));
  topics.acceleration.greetWith(greeting(
      [=](const Snapshot& snapshot, const ros::Time& stamp) {
        return toAcceleration(body, snapshot.motions({body})[0], stamp);
      },
      body));
  topics.applied_wrench.greetWith(
      greeting([=](const Snapshot& snapshot,
                   const ros::Time& stamp) { return toWrench(body, snapshot, stamp); },
               body));
  if (topics.pivot_force.greetWith)
    topics.pivot_force.greetWith(greeting(
        [=](const Snapshot& snapshot, const ros::Time& stamp) {
          return toPivotForce(body, snapshot.motions({body})[0], stamp);
        },
        body));
  if (!topics.actuators.greetWith) return;
  topics.actuators.greetWith(
      greeting([=](const Snapshot& snapshot,
                   const ros::Time& stamp) { return toActuators(body, snapshot, stamp); },
               body));
}

double Outputs::shownTime() const { return std::max(last_t_, simulation_->time()); }

std::optional<double> Outputs::instantWithinStep() const {
  const double h = simulation_->world().solver.time_step;
  const double t_end = static_cast<double>(simulation_->steps() + 1) * h;
  double t = state_instants_.next();
  if (publish_clock_) t = std::min(t, clock_instants_.next());
  t = std::min(t, imus_.next());
  if (t < t_end - instantRounding(t_end, h)) return t;
  return std::nullopt;
}

void Outputs::publishInstant(double t) { publishAt(t, t); }

void Outputs::publishWithinStep(double t_end) {
  const double reach = t_end + instantRounding(t_end, simulation_->world().solver.time_step);
  for (auto t = instantWithinStep(); t && *t <= reach; t = instantWithinStep()) publishInstant(*t);
}

void Outputs::publishDue() {
  const double t = simulation_->time();
  contacts_.keepChanges(*simulation_);
  publishAt(t, t + instantRounding(t, simulation_->world().solver.time_step));
}

/// Publishes at time t [s] what is due at instants up to `reach`.
void Outputs::publishAt(double t, double reach) {
  if (publish_clock_ && clock_instants_.next() <= reach) {
    clock_instants_.passTo(reach);
    publishClock(t);
  }
  if (imus_.publishDue(*simulation_, t, reach)) last_t_ = t;
  if (state_instants_.next() <= reach) {
    state_instants_.passTo(reach);
    const bool with_markers = marker_instants_.next() <= reach;
    marker_instants_.passTo(reach);
    publishState(t, with_markers);
  }
}

void Outputs::publishNow() {
  if (publish_clock_) publishClock(simulation_->time());
  publishState(simulation_->time(), true);
}

void Outputs::repeatClock() {
  if (!publish_clock_) return;
  rosgraph_msgs::Clock message;
  message.clock = origin_.stamp(shownTime());
  topics_.clock.publish(message, message.clock);
}

void Outputs::repeatState() {
  if (!anySubscribers()) return;
  const Snapshot snapshot = shown();
  publishBodyTopics(snapshot, origin_.stamp(snapshot.time()));
}

void Outputs::repeatBodies() {
  if (viewers_are_new_) topics_.markers.publish(bodies_, origin_.stamp(simulation_->time()));
  const std::size_t viewers = topics_.markers.subscribers();
  viewers_are_new_ = viewers > viewers_;
  viewers_ = viewers;
}

ros::Time Outputs::lastStamp() const {
  if (!last_state_stamp_ && !last_clock_stamp_) return origin_.stamp(simulation_->time());
  return std::max(last_state_stamp_.value_or(ros::Time()), last_clock_stamp_.value_or(ros::Time()));
}

void Outputs::restart(double t) {
  last_state_stamp_ = last_clock_stamp_ = greeted_ = std::nullopt;
  contacts_.restart();
  imus_.restart(t);
  last_t_ = 0;
  for (Instants* instants : {&state_instants_, &clock_instants_, &marker_instants_})
    instants->restart(t);
}

void Outputs::publishClock(double t) {
  rosgraph_msgs::Clock message;
  message.clock = origin_.stamp(t);
  if (message.clock <= last_clock_stamp_) return;
  last_clock_stamp_ = message.clock;
  last_t_ = t;
  topics_.clock.publish(message, message.clock);
}

void Outputs::publishState(double t, bool with_markers) {
  const ros::Time stamp = origin_.stamp(t);
  if (stamp <= last_state_stamp_) return;
  last_state_stamp_ = stamp;
  last_t_ = t;
  const bool seen = live_markers_.hasSubscribers();
  if (!seen) live_markers_.forget();
  if (!anySubscribers() && !topics_.tf.subscribers() && !(seen && with_markers)) return;
  const Snapshot snapshot(*simulation_, t);
  if (topics_.tf.subscribers() && stamp != greeted_)
    topics_.tf.publish(toTransforms(snapshot, stamp), stamp);
  publishBodyTopics(snapshot, stamp);
  if (seen && with_markers) live_markers_.publish(snapshot, stamp);
}

/// Of ~states, ~contacts, ~law_forces and the topics of single bodies.
bool Outputs::anySubscribers() const {
  return topics_.states.subscribers() > 0 || contacts_.hasSubscribers() ||
         topics_.law_forces.hasSubscribers() ||
         std::any_of(topics_.bodies.begin(), topics_.bodies.end(), [](const BodyTopics& topics) {
           return topics.odometry.subscribers() > 0 || topics.acceleration.subscribers() > 0 ||
                  topics.applied_wrench.subscribers() > 0 || topics.actuators.hasSubscribers() ||
                  topics.pivot_force.hasSubscribers();
         });
}

void Outputs::publishBodyTopics(const Snapshot& snapshot, const ros::Time& stamp) {
  if (topics_.states.subscribers()) {
    setStates(snapshot, stamp);
    topics_.states.publish(states_, stamp);
  }
  if (contacts_.hasSubscribers()) contacts_.publish(snapshot, stamp);
  if (topics_.law_forces.hasSubscribers())
    topics_.law_forces.publish(toLawForces(snapshot, world_frame_, stamp), stamp);
  for (const BodyTopics& topics : topics_.bodies) {
    if (isAbsent(topics.body)) continue;
    if (topics.odometry.subscribers())
      topics.odometry.publish(toOdometry(topics.body, snapshot, stamp), stamp);
    if (topics.applied_wrench.subscribers())
      topics.applied_wrench.publish(toWrench(topics.body, snapshot, stamp), stamp);
    if (topics.actuators.hasSubscribers())
      topics.actuators.publish(toActuators(topics.body, snapshot, stamp), stamp);
  }
  publishMotions(snapshot, stamp);
}

void Outputs::setStates(const Snapshot& snapshot, const ros::Time& stamp) {
  setBodyStates(snapshot.world(), present_, snapshot.bodies(), stamp, states_);
}

}  // namespace rigid_body_sim
