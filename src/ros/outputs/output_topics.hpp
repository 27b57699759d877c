#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <rigid_body_sim/BodyStates.h>
#include <rigid_body_sim/Contacts.h>
#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// The topics of a body that moves.
struct BodyTopics {
  std::size_t body;  ///< index
  Topic<nav_msgs::Odometry> odometry;
  Topic<geometry_msgs::WrenchStamped> applied_wrench;
};

/// What a run publishes, topic by topic.
struct OutputTopics {
  Topic<tf2_msgs::TFMessage> tf;
  Topic<tf2_msgs::TFMessage> tf_static;
  Topic<visualization_msgs::MarkerArray> markers;
  Topic<visualization_msgs::MarkerArray> live_markers;
  Topic<rosgraph_msgs::Clock> clock;  ///< empty functions unless chosen
  Topic<BodyStates> states;
  Topic<Contacts> contacts;  ///< empty functions unless bodies can touch
  std::vector<BodyTopics> bodies;
};

/// Which topics there are.
struct TopicChoice {
  bool clock = false;         ///< /clock
  bool single_bodies = true;  ///< those of BodyTopics
};

/// The topics of a body that moves, by the names that roscpp resolves. A Transport has
///   template <class Message> Topic<Message> open(const std::string& name, bool latched);
template <class Transport>
BodyTopics openBodyTopics(Transport& transport, const std::string& name, std::size_t body) {
  return {body, transport.template open<nav_msgs::Odometry>(name + "/odom", false),
          transport.template open<geometry_msgs::WrenchStamped>(name + "/applied_wrench", false)};
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
  if (hasContact(world))
    topics.contacts = transport.template open<Contacts>("~contacts", !kLatched);
  if (choice.clock)
    topics.clock = transport.template open<rosgraph_msgs::Clock>("/clock", !kLatched);
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].fixed || !choice.single_bodies) continue;
    topics.bodies.push_back(openBodyTopics(transport, world.bodies[i].name, i));
  }
  return topics;
}

}  // namespace rigid_body_sim
