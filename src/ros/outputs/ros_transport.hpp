#pragma once

#include <string>

#include <ros/names.h>
#include <ros/node_handle.h>

#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// Topics that are published. See openTopics.
class RosTransport {
 public:
  /// queue_size: messages that may wait for each subscriber.
  explicit RosTransport(const ros::NodeHandle& nh, std::uint32_t queue_size = 100)
      : nh_(nh), queue_size_(queue_size) {}

  template <class Message>
  Topic<Message> open(const std::string& name, bool latched) {
    const ros::Publisher publisher =
        nh_.advertise<Message>(ros::names::resolve(name), queue_size_, latched);
    return {[publisher] { return publisher.getNumSubscribers(); },
            [publisher](const Message& message, const ros::Time&) { publisher.publish(message); }};
  }

 private:
  ros::NodeHandle nh_;
  std::uint32_t queue_size_;
};

}  // namespace rigid_body_sim
