#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <ros/names.h>
#include <ros/node_handle.h>
#include <ros/single_subscriber_publisher.h>

#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// Topics that are published. See openTopics.
class RosTransport {
 public:
  /// Subscribers that come and go are noticed when the callback queue of the handle is served, in
  /// the thread that serves it. queue_size: messages that may wait for each subscriber.
  explicit RosTransport(const ros::NodeHandle& nh, std::uint32_t queue_size = 100)
      : nh_(nh), queue_size_(queue_size) {}

  template <class Message>
  Topic<Message> open(const std::string& name, bool latched) {
    const auto topic = std::make_shared<Advertised<Message>>();
    topic->changes = changes_;
    topic->advertise(nh_, ros::names::resolve(name), queue_size_, latched);
    return {
        [topic] { return topic->subscribers(); },
        [topic](const Message& message, const ros::Time&) { topic->publisher.publish(message); },
        [topic](typename Topic<Message>::Greeting greeting) {
          topic->greeting = std::move(greeting);
        }};
  }

  /// How often a subscriber of one of these topics has come or gone.
  std::function<std::size_t()> changes() const {
    return [changes = changes_] { return *changes; };
  }

 private:
  /// A publisher that knows how many subscribe. roscpp searches all publications of the node one by
  /// one when it is asked, so that it is asked only after somebody has come or gone.
  template <class Message>
  struct Advertised {
    void advertise(ros::NodeHandle& nh, const std::string& name, std::uint32_t queue_size,
                   bool latched) {
      publisher = nh.advertise<Message>(
          name, queue_size,
          [this](const ros::SingleSubscriberPublisher& subscriber) { greet(subscriber); },
          [this](const ros::SingleSubscriberPublisher&) { noteChange(); }, ros::VoidConstPtr(),
          latched);
    }

    void noteChange() {
      changed = true;
      ++*changes;
    }

    void greet(const ros::SingleSubscriberPublisher& subscriber) {
      noteChange();
      if (!greeting) return;
      if (const std::optional<Message> message = greeting()) subscriber.publish(*message);
    }

    std::size_t subscribers() {
      if (std::exchange(changed, false)) count = publisher.getNumSubscribers();
      return count;
    }

    typename Topic<Message>::Greeting greeting;
    bool changed = false;
    std::size_t count = 0;
    std::shared_ptr<std::size_t> changes;  // of all topics
    ros::Publisher publisher;              // last: its end ends the callbacks
  };

  ros::NodeHandle nh_;
  std::uint32_t queue_size_;
  std::shared_ptr<std::size_t> changes_ = std::make_shared<std::size_t>(0);
};

}  // namespace rigid_body_sim
