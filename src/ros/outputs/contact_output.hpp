#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigid_body_sim/Contacts.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/snapshot.hpp"
#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// The topic ~contacts: what touches at the instants of the states, with every touch and release
/// between them. Computed while there are subscribers.
class ContactOutput {
 public:
  /// The origin is referred to, not copied.
  ContactOutput(Topic<Contacts> topic, std::string world_frame, const TimeOrigin& origin);

  bool hasSubscribers() const { return topic_.hasSubscribers(); }

  /// Keeps the touches and releases within the last step of a simulation, once, until the next
  /// message.
  void keepChanges(const Simulation& simulation);

  /// Publishes, and forgets the changes.
  void publish(const Snapshot& snapshot, const ros::Time& stamp);

  /// What touches, without changes.
  Contacts standing(const Snapshot& snapshot, const ros::Time& stamp) const;

  /// Who comes while time stands is sent what `greeting` gives.
  void greetWith(Topic<Contacts>::Greeting greeting);

  /// Time has been set back to the start.
  void restart();

 private:
  Topic<Contacts> topic_;
  std::string world_frame_;
  const TimeOrigin& origin_;
  std::vector<ContactChange> changes_;
  std::int64_t kept_steps_ = -1;  // of the last step whose changes were kept
};

}  // namespace rigid_body_sim
