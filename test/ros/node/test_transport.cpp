#include <vector>

#include <geometry_msgs/Vector3.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "node_driver.hpp"
#include "ros/outputs/ros_transport.hpp"

namespace rigid_body_sim {
namespace {

using Message = geometry_msgs::Vector3;

/// A topic whose own queue is served where a test says so, and its subscribers.
struct Transport : ::testing::Test {
  Transport() {
    nh.setCallbackQueue(&queue);
    topic = RosTransport(nh).open<Message>("topic", false);
  }

  ros::Subscriber connected() {
    const boost::function<void(const Message&)> receive = [this](const Message& message) {
      received.push_back(message.x);
    };
    ros::NodeHandle subscriber_nh;
    const ros::Subscriber subscriber = subscriber_nh.subscribe<Message>("topic", 10, receive);
    EXPECT_TRUE(NodeDriver::waitFor([&] { return subscriber.getNumPublishers() == 1; }));
    return subscriber;
  }

  ros::CallbackQueue queue;
  ros::NodeHandle nh;
  Topic<Message> topic;
  std::vector<double> received;
};

}  // namespace

// Asking roscpp searches all publications of the node: with two for each body, a tick would be
// quadratic in bodies. So the number must come from the queue, and from nowhere else.
TEST_F(Transport, NumberOfSubscribersChangesWhenTheQueueReportsIt) {
  EXPECT_EQ(topic.subscribers(), 0U);
  ros::Subscriber subscriber = connected();
  EXPECT_EQ(topic.subscribers(), 0U);
  queue.callAvailable();
  EXPECT_EQ(topic.subscribers(), 1U);
  subscriber.shutdown();
  EXPECT_EQ(topic.subscribers(), 1U);
  ASSERT_TRUE(NodeDriver::waitFor([&] {
    queue.callAvailable();
    return topic.subscribers() == 0;
  }));
}

TEST_F(Transport, NewSubscribersAreGreetedOnce) {
  topic.greetWith([] {
    Message greeting;
    greeting.x = 7;
    return greeting;
  });
  const ros::Subscriber subscriber = connected();
  queue.callAvailable();
  Message next;
  next.x = 8;
  topic.publish(next, ros::Time());
  EXPECT_TRUE(NodeDriver::waitFor([this] { return received.size() == 2; }));
  EXPECT_EQ(received, (std::vector<double>{7, 8}));
}

}  // namespace rigid_body_sim
