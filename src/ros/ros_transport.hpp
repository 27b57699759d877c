#pragma once

#include <string>

#include <ros/names.h>
#include <ros/node_handle.h>

#include "topic.hpp"

namespace rigid_body_sim {

/// Topics that are published. See openTopics.
class RosTransport {
 public:
  explicit RosTransport(const ros::NodeHandle& nh) : nh_(nh) {}

  template <class Message>
  Topic<Message> open(const std::string& name, bool latched) {
    constexpr std::uint32_t kQueueSize = 100;
    const ros::Publisher publisher =
        nh_.advertise<Message>(ros::names::resolve(name), kQueueSize, latched);
    return {[publisher] { return publisher.getNumSubscribers() > 0; },
            [publisher](const Message& message, const ros::Time&) { publisher.publish(message); }};
  }

 private:
  ros::NodeHandle nh_;
};

}  // namespace rigid_body_sim
