#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <geometry_msgs/AccelStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <rigid_body_sim/BodyStates.h>
#include <rigid_body_sim/Contacts.h>
#include <rigid_body_sim/LawForces.h>
#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/line_force.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/world_changes.hpp"
#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// The topics of an IMU.
struct ImuTopics {
  std::size_t imu = 0;              ///< index in World::imus
  Topic<sensor_msgs::Imu> reading;  ///< with noise
  Topic<sensor_msgs::Imu> truth;
};

/// The topics of a body. Of one that is fixed, those of its IMUs alone; the others are then empty
/// functions.
struct BodyTopics {
  std::size_t body = 0;  ///< index
  Topic<nav_msgs::Odometry> odometry;
  Topic<geometry_msgs::AccelStamped> acceleration;
  Topic<geometry_msgs::WrenchStamped> applied_wrench;
  Topic<sensor_msgs::JointState> actuators;         ///< empty functions unless the body has some
  Topic<geometry_msgs::WrenchStamped> pivot_force;  ///< empty functions unless it is on a pivot
  std::vector<ImuTopics> imus;
};

/// What a run publishes, topic by topic.
struct OutputTopics {
  Topic<tf2_msgs::TFMessage> tf;
  Topic<tf2_msgs::TFMessage> tf_static;
  Topic<visualization_msgs::MarkerArray> markers;
  Topic<visualization_msgs::MarkerArray> live_markers;
  Topic<rosgraph_msgs::Clock> clock;  ///< empty functions unless chosen
  Topic<BodyStates> states;
  Topic<Contacts> contacts;     ///< empty functions unless bodies can touch
  Topic<LawForces> law_forces;  ///< empty functions unless there are springs or tethers
  std::vector<BodyTopics> bodies;
  /// How often a subscriber of any of them has come or gone, where that is known: thousands of
  /// topics need not be asked one by one then.
  std::function<std::size_t()> changes{};
};

/// Which topics there are.
struct TopicChoice {
  bool clock = false;         ///< /clock
  bool single_bodies = true;  ///< those of BodyTopics
};

/// Those of a body that moves, but for its IMUs. A Transport has
///   template <class Message> Topic<Message> open(const std::string& name, bool latched);
template <class Transport>
void openMotionTopics(Transport& transport, const Body& body, BodyTopics& topics) {
  topics.odometry = transport.template open<nav_msgs::Odometry>(body.name + "/odom", false);
  topics.acceleration =
      transport.template open<geometry_msgs::AccelStamped>(body.name + "/accel", false);
  topics.applied_wrench =
      transport.template open<geometry_msgs::WrenchStamped>(body.name + "/applied_wrench", false);
  if (!body.actuators.empty())
    topics.actuators =
        transport.template open<sensor_msgs::JointState>(body.name + "/actuators", false);
  if (body.pivoted)
    topics.pivot_force =
        transport.template open<geometry_msgs::WrenchStamped>(body.name + "/pivot_force", false);
}

/// The topics of a body of the world, by the names that roscpp resolves; Transport as above.
template <class Transport>
BodyTopics openBodyTopics(Transport& transport, const World& world, std::size_t body) {
  BodyTopics topics;
  topics.body = body;
  if (!world.bodies[body].fixed) openMotionTopics(transport, world.bodies[body], topics);
  for (std::size_t i = 0; i < world.imus.size(); ++i) {
    if (world.imus[i].body != body) continue;
    const std::string name = world.bodies[body].name + "/" + world.imus[i].name;
    topics.imus.push_back({i, transport.template open<sensor_msgs::Imu>(name, false),
                           transport.template open<sensor_msgs::Imu>(name + "/truth", false)});
  }
  return topics;
}

/// All topics; Transport as above.
template <class Transport>
OutputTopics openTopics(Transport& transport, const World& world, const TopicChoice& choice) {
  constexpr bool kLatched = true;
  OutputTopics topics;
  topics.tf = transport.template open<tf2_msgs::TFMessage>("/tf", !kLatched);
  topics.tf_static = transport.template open<tf2_msgs::TFMessage>("/tf_static", kLatched);
  topics.markers = transport.template open<visualization_msgs::MarkerArray>("~markers", kLatched);
  // after the bodies: a publisher latches its own messages only, and whoever comes late is sent the
  // bodies, not old arrows
  topics.live_markers =
      transport.template open<visualization_msgs::MarkerArray>("~markers", !kLatched);
  topics.states = transport.template open<BodyStates>("~states", !kLatched);
  const World as_given = withoutChanges(world);  // laws of which a body is absent rest
  if (hasContact(as_given))
    topics.contacts = transport.template open<Contacts>("~contacts", !kLatched);
  if (hasLines(as_given))
    topics.law_forces = transport.template open<LawForces>("~law_forces", !kLatched);
  if (choice.clock)
    topics.clock = transport.template open<rosgraph_msgs::Clock>("/clock", !kLatched);
  for (std::size_t i = 0; i < world.bodies.size() && choice.single_bodies; ++i) {
    BodyTopics of_body = openBodyTopics(transport, world, i);
    if (!world.bodies[i].fixed || !of_body.imus.empty())
      topics.bodies.push_back(std::move(of_body));
  }
  return topics;
}

}  // namespace rigid_body_sim
