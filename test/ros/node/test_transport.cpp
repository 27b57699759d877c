#include <cmath>
#include <vector>

#include <geometry_msgs/Vector3.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "node_driver.hpp"
#include "ros/mouse/handle_topics.hpp"
#include "ros/node/monitor.hpp"
#include "ros/outputs/ros_transport.hpp"

namespace rigid_body_sim {
namespace {

using Message = geometry_msgs::Vector3;

/// A topic whose own queue is served where a test says so, and its subscribers.
struct Transport : ::testing::Test {
  Transport() {
    nh.setCallbackQueue(&queue);
    private_nh.setCallbackQueue(&queue);
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
  ros::NodeHandle private_nh{"~"};
  Topic<Message> topic;
  std::vector<double> received;
};

/// Connected, and not reported to the queue of the publisher yet.
template <class Message>
ros::Subscriber connectedTo(const std::string& topic, std::vector<Message>& received) {
  ros::NodeHandle nh("~");
  const boost::function<void(const Message&)> receive = [&received](const Message& message) {
    received.push_back(message);
  };
  const ros::Subscriber subscriber = nh.subscribe<Message>(topic, 10, receive);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return subscriber.getNumPublishers() == 1; }));
  return subscriber;
}

/// A monitor whose queue has not been told of its listener yet.
struct TransportOfMonitor : Transport {
  Simulation simulation{World(), State()};
  TimeOrigin origin;
  Monitor monitor{nh, private_nh, "world", simulation, origin};
  std::vector<SimStatus> reports;
  ros::Subscriber listener = connectedTo("status", reports);
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

// Neither do those ask roscpp that look for listeners once a second or more often: what they would
// send before the queue is served is not sent.
TEST_F(Transport, HandlesAreKeptAliveOnceTheQueueReportsAViewer) {
  using visualization_msgs::InteractiveMarkerUpdate;
  HandleTopics handles(private_nh, {}, [](const HandleTopics::Feedback&) {});
  std::vector<InteractiveMarkerUpdate> updates;
  const ros::Subscriber viewer = connectedTo("push/update", updates);
  HandleTopics::Clock::time_point now = HandleTopics::Clock::now();
  handles.keepAlive(now);
  queue.callAvailable();
  handles.add({});
  handles.keepAlive(now += std::chrono::seconds(1));
  ASSERT_TRUE(NodeDriver::waitFor([&] { return updates.size() == 2; }));
  EXPECT_EQ(updates[0].type, InteractiveMarkerUpdate::UPDATE);
  EXPECT_EQ(updates[1].type, InteractiveMarkerUpdate::KEEP_ALIVE);
}

TEST_F(TransportOfMonitor, StatusIsReportedOnceTheQueueReportsAListener) {
  Health health;
  for (const unsigned overruns : {1U, 2U}) {
    health.status.overruns = overruns;
    monitor.report(health, Monitor::Clock::now());
    queue.callAvailable();
  }
  health.status.overruns = 3;
  monitor.report(health, Monitor::Clock::now());
  ASSERT_TRUE(NodeDriver::waitFor([&] { return reports.size() == 2; }));
  EXPECT_EQ(reports[0].overruns, 2U);
  EXPECT_EQ(reports[1].overruns, 3U);
}

// Steps that are taken before the next report count in the balance.
TEST_F(TransportOfMonitor, BalancesBeginOnceTheQueueReportsAListener) {
  monitor.beginWhereAskedFor();
  EXPECT_TRUE(std::isnan(simulation.balance().energy));
  queue.callAvailable();
  monitor.beginWhereAskedFor();
  EXPECT_FALSE(std::isnan(simulation.balance().energy));
}

}  // namespace rigid_body_sim
