#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include <ros/time.h>

namespace rigid_body_sim {

/// A topic to write to, whatever lies behind it: a publisher of ROS or a bag.
template <class Message>
struct Topic {
  /// What a subscriber is sent as soon as it has come; none: nothing but what is published later.
  using Greeting = std::function<std::optional<Message>()>;

  bool hasSubscribers() const { return subscribers && subscribers() > 0; }

  std::function<std::size_t()> subscribers;  ///< their number; cheap enough to ask at every tick
  std::function<void(const Message&, const ros::Time& stamp)> publish;
  std::function<void(Greeting)> greetWith{};  ///< from now on; a bag is never greeted
};

}  // namespace rigid_body_sim
