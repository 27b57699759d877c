#pragma once

#include <string>

#include <boost/function.hpp>
#include <ros/node_handle.h>

#include "ros/inputs/inputs.hpp"
#include "ros/inputs/lockstep.hpp"
#include "ros/inputs/message_limits.hpp"
#include "ros/inputs/refusals.hpp"

namespace rigid_body_sim {

/// What the interfaces through which inputs come have in common. All of it is referred to.
struct InputContext {
  const Simulation& simulation;
  Inputs& inputs;
  const TimeOrigin& origin;
  Refusals& refusals;
  Lockstep& lockstep;

  /// Applies the inputs that `read` makes of a message, all or none. Returns why they are refused;
  /// empty if they are not.
  template <class Read>
  std::string apply(const char* what, const Read& read) const {
    try {
      for (const auto& input : read(simulation.time())) inputs.apply(input);
      return "";
    } catch (const std::invalid_argument& refused) {
      refusals.add(what, refused.what());
      return refused.what();
    }
  }

  /// Subscribes to messages that are to be taken one by one, at once or, on a topic of the
  /// lockstep, in their turn.
  template <class Message>
  ros::Subscriber subscribe(ros::NodeHandle nh, const std::string& topic,
                            const std::function<void(const Message&)>& take) const {
    using Callback = boost::function<void(const boost::shared_ptr<const Message>&)>;
    Callback callback = [take](const auto& message) { take(*message); };
    const std::string name = nh.resolveName(topic);
    if (lockstep.take(name))
      callback = [&steps = lockstep, name, take](const auto& message) {
        steps.hold(name, *message, [message, take] { take(*message); });
      };
    return nh.subscribe<Message>(topic, kMessageQueue, callback, ros::VoidConstPtr(),
                                 ros::TransportHints().tcpNoDelay());
  }
};

}  // namespace rigid_body_sim
