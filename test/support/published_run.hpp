#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/outputs/outputs.hpp"
#include "support/lopsided_box.hpp"

/// What tests of the output share.
namespace rigid_body_sim::test {

/// Keeps what is published.
struct PublishedMessages {
  template <class Message>
  Topic<Message> open(const std::string& name, bool) {
    names.insert(name);
    return {[this] { return subscribers; },
            [this, name](const Message& message, const ros::Time&) { keep(name, message); },
            [this, name](const typename Topic<Message>::Greeting& greeting) {
              // who comes is a subscriber of its own
              come[name] = [this, name, greeting] {
                if (const auto message = greeting()) keep(name, *message);
              };
            }};
  }

  void keep(const std::string& name, const nav_msgs::Odometry& m) { odometry[name].push_back(m); }
  void keep(const std::string& name, const geometry_msgs::WrenchStamped& m) {
    applied[name].push_back(m);
  }
  void keep(const std::string& name, const geometry_msgs::AccelStamped& m) {
    accelerations[name].push_back(m);
  }
  void keep(const std::string& name, const sensor_msgs::Imu& m) { imu[name].push_back(m); }
  void keep(const std::string&, const tf2_msgs::TFMessage& m) { tf.push_back(m); }
  void keep(const std::string&, const BodyStates& m) { states.push_back(m); }
  void keep(const std::string&, const Contacts& m) { contacts.push_back(m); }
  void keep(const std::string&, const LawForces& m) { law_forces.push_back(m); }
  void keep(const std::string&, const rosgraph_msgs::Clock& m) { clock.push_back(m.clock); }
  template <class Message>
  void keep(const std::string& name, const Message&) {
    ++others[name];
  }

  std::set<std::string> names;  // of the topics
  std::map<std::string, std::function<void()>> come;
  std::size_t subscribers = 1;
  std::map<std::string, std::vector<nav_msgs::Odometry>> odometry;
  std::map<std::string, std::vector<geometry_msgs::WrenchStamped>> applied;
  std::map<std::string, std::vector<geometry_msgs::AccelStamped>> accelerations;
  std::map<std::string, std::vector<sensor_msgs::Imu>> imu;
  std::vector<tf2_msgs::TFMessage> tf;  // the static ones first
  std::vector<BodyStates> states;
  std::vector<Contacts> contacts;
  std::vector<LawForces> law_forces;
  std::vector<ros::Time> clock;
  std::map<std::string, int> others;
};

/// A run with all that it publishes, /clock too.
struct PublishedRun {
  PublishedRun(const Scene& of_scene, double rate) : scene(of_scene), options(optionsOf(rate)) {}

  /// Under wrenches; with a rate of 0 [Hz] at every step.
  explicit PublishedRun(double time_step, double rate = 0)
      : PublishedRun(sceneOf(time_step), rate > 0 ? rate : 1 / time_step) {}

  static NodeOptions optionsOf(double rate) {
    NodeOptions at_rate;
    at_rate.publish_clock = true;
    at_rate.publish_rate = rate;
    return at_rate;
  }

  static Scene sceneOf(double time_step) {
    Scene scene = parseScene(R"(
time_step: 1
gravity: [0.1, 0, -9.80665]
bodies:
)" + kLopsidedBox + R"(    position: [1, 2, 3]
    orientation: [0.5, 0.5, 0.5, 0.5]
    twist: {frame: world, linear: [1, -2, 3], angular: [0.5, -1, 2]}
    points: {tip: {position: [1, 0, -0.5]}}
  - {name: ball, shape: {sphere: {radius: 1}}, mass: 1}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 1, position: [5, 0, 0], fixed: true}
wrenches:
  - {body: box, frame: box/tip, force: [1, 2, 3], torque: [1, 0, 0], duration: 10}
  - {body: box, frame: world, point: [0.1, 0.2, 0.3], force: [3, 2, 1], duration: 10}
)",
                             "test");
    scene.time_step = time_step;
    return scene;
  }

  void steps(int count) {
    outputs.publishDue();
    for (int i = 0; i < count; ++i) {
      outputs.publishWithinStep(1e9);
      simulation.step();
      outputs.publishDue();
    }
  }

  void runUntil(double t_end) {
    steps(static_cast<int>(std::lround((t_end - simulation.time()) / scene.time_step)));
  }

  Scene scene;
  NodeOptions options;
  World world = buildWorld(scene);
  Simulation simulation{world, initialState(scene, world)};
  TimeOrigin origin{ros::Time(1600000000, 123456789)};
  PublishedMessages published;
  Outputs outputs{openTopics(published, world, {true}), options, scene, simulation, origin};
};

inline Quaterniond attitude(const nav_msgs::Odometry& m) {
  const geometry_msgs::Quaternion& q = m.pose.pose.orientation;
  return {q.w, q.x, q.y, q.z};
}

inline Vector3d position(const nav_msgs::Odometry& m) { return fromPoint(m.pose.pose.position); }

/// The rotation vector from one attitude to another, in the axes of the first.
inline Vector3d rotationBetween(const Quaterniond& a, const Quaterniond& b) {
  const Eigen::AngleAxisd rotation(a.conjugate() * b);
  return rotation.angle() * rotation.axis();
}

}  // namespace rigid_body_sim::test
