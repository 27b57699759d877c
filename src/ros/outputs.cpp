#include "outputs.hpp"

#include <algorithm>

#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include "markers.hpp"
#include "state_messages.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::uint32_t kQueueSize = 100;
constexpr bool kLatched = true;

/// Arrows and trails are for the eye [1/s of simulation time].
constexpr double kMarkerRate = 30;

Isometry3d poseOf(const PointDef& point) {
  Isometry3d X_BF = Isometry3d::Identity();
  X_BF.linear() = point.orientation.toRotationMatrix();
  X_BF.translation() = point.position;
  return X_BF;
}

}  // namespace

Outputs::Outputs(ros::NodeHandle nh, ros::NodeHandle private_nh, const NodeOptions& options,
                 const Scene& scene, const Simulation& simulation, const TimeOrigin& origin)
    : simulation_(simulation),
      world_frame_(scene.world_frame),
      origin_(origin),
      publish_clock_(options.publish_clock),
      state_ticker_(options.publish_rate),
      clock_ticker_(options.clock_rate),
      marker_ticker_(std::min(options.publish_rate, kMarkerRate)),
      tf_(nh.advertise<tf2_msgs::TFMessage>("/tf", kQueueSize)),
      tf_static_(nh.advertise<tf2_msgs::TFMessage>("/tf_static", kQueueSize, kLatched)),
      markers_(
          private_nh.advertise<visualization_msgs::MarkerArray>("markers", kQueueSize, kLatched)),
      live_markers_(private_nh, scene.world_frame, simulation),
      states_(private_nh.advertise<BodyStates>("states", kQueueSize)) {
  if (publish_clock_) clock_ = nh.advertise<rosgraph_msgs::Clock>("/clock", kQueueSize);
  const std::vector<Body>& bodies = simulation.world().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string& name = bodies[i].name;
    if (bodies[i].fixed) continue;
    bodies_.push_back(
        {i, nh.advertise<nav_msgs::Odometry>(name + "/odom", kQueueSize),
         nh.advertise<geometry_msgs::WrenchStamped>(name + "/applied_wrench", kQueueSize)});
  }
  publishOnce(scene);
}

void Outputs::publishOnce(const Scene& scene) {
  const ros::Time stamp = origin_.stamp(0);
  const std::vector<Body>& bodies = simulation_.world().bodies;
  tf2_msgs::TFMessage frames;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    if (body.fixed)
      frames.transforms.push_back(
          toTransform(body, simulation_.state().bodies[i], world_frame_, stamp));
    for (const PointDef& point : scene.bodies[i].points)
      frames.transforms.push_back(
          toTransform(poseOf(point), body.name, body.name + "/" + point.name, stamp));
  }
  if (!frames.transforms.empty()) tf_static_.publish(frames);
  markers_.publish(toMarkers(scene));
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

void Outputs::restart() {
  state_ticker_.restart();
  clock_ticker_.restart();
  marker_ticker_.restart();
  last_state_stamp_ = last_clock_stamp_ = last_marker_stamp_ = ros::Time();
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
  clock_.publish(message);
}

void Outputs::publishState() {
  const ros::Time stamp = origin_.stamp(simulation_.time());
  if (stamp <= last_state_stamp_) return;
  last_state_stamp_ = stamp;
  if (tf_.getNumSubscribers() > 0) publishTransforms(stamp);
  if (states_.getNumSubscribers() > 0)
    states_.publish(toBodyStates(simulation_.world(), simulation_.state(), world_frame_, stamp));
  for (const BodyTopics& topics : bodies_) publishBody(topics, stamp);
}

void Outputs::publishTransforms(const ros::Time& stamp) {
  tf2_msgs::TFMessage frames;
  frames.transforms.reserve(bodies_.size());
  for (const BodyTopics& topics : bodies_)
    frames.transforms.push_back(toTransform(simulation_.world().bodies[topics.body],
                                            simulation_.state().bodies[topics.body], world_frame_,
                                            stamp));
  tf_.publish(frames);
}

void Outputs::publishBody(const BodyTopics& topics, const ros::Time& stamp) {
  const Body& body = simulation_.world().bodies[topics.body];
  const BodyState& state = simulation_.state().bodies[topics.body];
  if (topics.odometry.getNumSubscribers() > 0)
    topics.odometry.publish(toOdometry(body, state, world_frame_, stamp));
  if (topics.applied_wrench.getNumSubscribers() > 0)
    topics.applied_wrench.publish(
        toWrenchStamped(body, state, simulation_.appliedWrench(topics.body), stamp));
}

}  // namespace rigid_body_sim
