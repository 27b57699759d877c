#include "ros/outputs/outputs.hpp"

#include <algorithm>
#include <utility>

#include <rigid_body_sim/math/isometry.hpp>

#include "ros/outputs/markers.hpp"
#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {
namespace {

/// Arrows and trails are for the eye [1/s of simulation time].
constexpr double kMarkerRate = 30;

}  // namespace

Outputs::Outputs(OutputTopics topics, const NodeOptions& options, const Scene& scene,
                 const Simulation& simulation, const TimeOrigin& origin)
    : topics_(std::move(topics)),
      simulation_(simulation),
      origin_(origin),
      world_frame_(scene.world_frame),
      publish_clock_(options.publish_clock),
      state_ticker_(options.publish_rate, scene.time_step),
      clock_ticker_(options.clock_rate, scene.time_step),
      marker_ticker_(std::min(options.publish_rate, kMarkerRate), scene.time_step),
      live_markers_(topics_.live_markers, scene.world_frame, simulation),
      bodies_(toMarkers(scene)) {
  publishOnce(scene);
}

void Outputs::publishOnce(const Scene& scene) {
  const ros::Time stamp = origin_.stamp(0);
  const std::vector<Body>& bodies = simulation_.world().bodies;
  tf2_msgs::TFMessage frames;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    if (body.fixed)
      frames.transforms.push_back(toTransform(body, simulation_.body(i), world_frame_, stamp));
    for (const PointDef& point : scene.bodies[i].points)
      frames.transforms.push_back(toTransform(isometry(point.orientation, point.position),
                                              body.name, body.name + "/" + point.name, stamp));
  }
  if (!frames.transforms.empty()) topics_.tf_static.publish(frames, stamp);
  topics_.markers.publish(bodies_, stamp);
}

void Outputs::publishDue() {
  const double t = simulation_.time();
  if (publish_clock_ && clock_ticker_.due(t)) publishClock();
  if (state_ticker_.due(t)) publishState();
  if (marker_ticker_.due(t)) publishMarkers();
}

void Outputs::publishNow() {
  if (publish_clock_) publishClock();
  publishState();
  publishMarkers();
}

void Outputs::repeatBodies() {
  if (viewers_are_new_) topics_.markers.publish(bodies_, origin_.stamp(simulation_.time()));
  const std::size_t viewers = topics_.markers.subscribers();
  viewers_are_new_ = viewers > viewers_;
  viewers_ = viewers;
}

void Outputs::restart() {
  last_state_stamp_.reset();
  last_clock_stamp_.reset();
  last_marker_stamp_.reset();
}

void Outputs::publishMarkers() {
  const ros::Time stamp = origin_.stamp(simulation_.time());
  if (stamp <= last_marker_stamp_) return;
  last_marker_stamp_ = stamp;
  live_markers_.publish(stamp);
}

void Outputs::publishClock() {
  rosgraph_msgs::Clock message;
  message.clock = origin_.stamp(simulation_.time());
  if (message.clock <= last_clock_stamp_) return;
  last_clock_stamp_ = message.clock;
  topics_.clock.publish(message, message.clock);
}

void Outputs::publishState() {
  const ros::Time stamp = origin_.stamp(simulation_.time());
  if (stamp <= last_state_stamp_) return;
  last_state_stamp_ = stamp;
  if (topics_.tf.subscribers()) publishTransforms(stamp);
  if (topics_.states.subscribers())
    topics_.states.publish(
        toBodyStates(simulation_.world(), simulation_.state(), world_frame_, stamp), stamp);
  for (const BodyTopics& topics : topics_.bodies) publishBody(topics, stamp);
}

void Outputs::publishTransforms(const ros::Time& stamp) {
  tf2_msgs::TFMessage frames;
  frames.transforms.reserve(topics_.bodies.size());
  for (const BodyTopics& topics : topics_.bodies)
    frames.transforms.push_back(toTransform(simulation_.world().bodies[topics.body],
                                            simulation_.body(topics.body), world_frame_, stamp));
  topics_.tf.publish(frames, stamp);
}

void Outputs::publishBody(const BodyTopics& topics, const ros::Time& stamp) {
  const Body& body = simulation_.world().bodies[topics.body];
  const BodyState& state = simulation_.body(topics.body);
  if (topics.odometry.subscribers())
    topics.odometry.publish(toOdometry(body, state, world_frame_, stamp), stamp);
  if (topics.applied_wrench.subscribers())
    topics.applied_wrench.publish(
        toWrenchStamped(body, state, simulation_.appliedWrench(topics.body), stamp), stamp);
}

}  // namespace rigid_body_sim
