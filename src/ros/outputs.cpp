#include "outputs.hpp"

#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include "markers.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::uint32_t kQueueSize = 100;
constexpr bool kLatched = true;

Isometry3d poseOf(const PointDef& point) {
  Isometry3d X_BF = Isometry3d::Identity();
  X_BF.linear() = point.orientation.toRotationMatrix();
  X_BF.translation() = point.position;
  return X_BF;
}

}  // namespace

Outputs::Outputs(ros::NodeHandle nh, ros::NodeHandle private_nh, const NodeOptions& options,
                 const Scene& scene, const World& world, const State& initial,
                 const TimeOrigin& origin)
    : world_(world),
      world_frame_(scene.world_frame),
      origin_(origin),
      publish_clock_(options.publish_clock),
      state_ticker_(options.publish_rate),
      clock_ticker_(options.clock_rate),
      tf_(nh.advertise<tf2_msgs::TFMessage>("/tf", kQueueSize)),
      tf_static_(nh.advertise<tf2_msgs::TFMessage>("/tf_static", kQueueSize, kLatched)),
      markers_(
          private_nh.advertise<visualization_msgs::MarkerArray>("markers", kQueueSize, kLatched)) {
  if (publish_clock_) clock_ = nh.advertise<rosgraph_msgs::Clock>("/clock", kQueueSize);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    if (!body.fixed)
      odometers_.push_back({i, nh.advertise<nav_msgs::Odometry>(body.name + "/odom", kQueueSize)});
  }
  publishOnce(scene, initial);
}

void Outputs::publishOnce(const Scene& scene, const State& initial) {
  const ros::Time stamp = origin_.stamp(0);
  tf2_msgs::TFMessage frames;
  for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
    const Body& body = world_.bodies[i];
    if (body.fixed)
      frames.transforms.push_back(toTransform(body, initial.bodies[i], world_frame_, stamp));
    for (const PointDef& point : scene.bodies[i].points)
      frames.transforms.push_back(
          toTransform(poseOf(point), body.name, body.name + "/" + point.name, stamp));
  }
  if (!frames.transforms.empty()) tf_static_.publish(frames);
  markers_.publish(toMarkers(scene));
}

void Outputs::publishDue(const State& state) {
  if (publish_clock_ && clock_ticker_.due(state.t)) publishClock(state);
  if (state_ticker_.due(state.t)) publishState(state);
}

void Outputs::publishNow(const State& state) {
  if (publish_clock_) publishClock(state);
  publishState(state);
}

void Outputs::restart() {
  state_ticker_.restart();
  clock_ticker_.restart();
  last_state_stamp_ = last_clock_stamp_ = ros::Time();
}

void Outputs::publishClock(const State& state) {
  rosgraph_msgs::Clock message;
  message.clock = origin_.stamp(state.t);
  if (message.clock <= last_clock_stamp_) return;
  last_clock_stamp_ = message.clock;
  clock_.publish(message);
}

void Outputs::publishState(const State& state) {
  const ros::Time stamp = origin_.stamp(state.t);
  if (stamp <= last_state_stamp_) return;
  last_state_stamp_ = stamp;
  if (tf_.getNumSubscribers() > 0) publishTransforms(state, stamp);
  for (const Odometer& odometer : odometers_) {
    if (odometer.publisher.getNumSubscribers() == 0) continue;
    odometer.publisher.publish(
        toOdometry(world_.bodies[odometer.body], state.bodies[odometer.body], world_frame_, stamp));
  }
}

void Outputs::publishTransforms(const State& state, const ros::Time& stamp) {
  tf2_msgs::TFMessage frames;
  frames.transforms.reserve(odometers_.size());
  for (const Odometer& odometer : odometers_)
    frames.transforms.push_back(toTransform(world_.bodies[odometer.body],
                                            state.bodies[odometer.body], world_frame_, stamp));
  tf_.publish(frames);
}

}  // namespace rigid_body_sim
