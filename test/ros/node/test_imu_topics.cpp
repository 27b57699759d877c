#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sensor_msgs/Imu.h>
#include <tf2_msgs/TFMessage.h>

#include "message_bytes.hpp"
#include "node_driver.hpp"
#include "support/published_run.hpp"

namespace rigid_body_sim {
namespace {

constexpr int kSteps = 2500;  // 40 s, as long as anything is compared

/// Samples by topic and stamp.
using Samples = std::map<std::string, std::map<ros::Time, sensor_msgs::Imu>>;

/// All that a run publishes to which everybody listens from the start on, computed here.
Samples expectedSamples() {
  test::PublishedRun run(loadScene(RIGID_BODY_SIM_IMU_SCENE), 100);
  run.origin = TimeOrigin();
  run.steps(kSteps);
  Samples samples;
  for (const auto& [name, messages] : run.published.imu)
    for (const sensor_msgs::Imu& message : messages) samples[name][message.header.stamp] = message;
  return samples;
}

class ImuTopicsOfANode : public ::testing::Test {
 protected:
  /// Keeps what comes on a topic among the samples of a listener.
  ros::Subscriber listen(const std::string& topic, Samples& samples) {
    const boost::function<void(const sensor_msgs::Imu&)> keep =
        [&samples, topic](const sensor_msgs::Imu& m) { samples[topic][m.header.stamp] = m; };
    ros::Subscriber subscriber = nh.subscribe<sensor_msgs::Imu>(topic, 100000, keep);
    EXPECT_TRUE(NodeDriver::waitFor([&] { return subscriber.getNumPublishers() > 0; }));
    return subscriber;
  }

  /// The samples are those of the run that was computed here, to the bit.
  void expectRight(const Samples& samples, const std::string& topic) const {
    ASSERT_EQ(samples.count(topic), 1U) << topic;
    const auto& of_topic = expected.at(topic);
    ASSERT_LT(samples.at(topic).begin()->first, of_topic.rbegin()->first);
    for (const auto& [stamp, message] : samples.at(topic)) {
      if (stamp > of_topic.rbegin()->first) continue;
      ASSERT_EQ(of_topic.count(stamp), 1U) << topic << " " << stamp;
      ASSERT_EQ(bytesOf(message), bytesOf(of_topic.at(stamp))) << topic << " " << stamp;
    }
  }

  ros::NodeHandle nh;
  const Samples expected = expectedSamples();
};

}  // namespace

TEST_F(ImuTopicsOfANode, HaveTheSameBitsForEarlyAndLateListeners) {
  NodeDriver driver({"box"});
  driver.connect();
  Samples early, late;
  const ros::Subscriber truth = listen("box/imu/truth", early);
  // the connection may come late
  ASSERT_TRUE(NodeDriver::waitFor([&] {
    driver.step(1);
    return early.count("box/imu/truth") > 0;
  }));
  driver.step(30);
  const ros::Subscriber of_box = listen("box/imu", early), of_post = listen("post/imu", early);
  driver.step(30);
  ASSERT_TRUE(NodeDriver::waitFor([&] {
    return !early["box/imu"].empty() && !early["post/imu"].empty() &&
           early["box/imu"].rbegin()->first == early["box/imu/truth"].rbegin()->first;
  }));
  // every sample of the last 60 steps has come, 960 ms of 5 ms
  EXPECT_GE(early["box/imu/truth"].size(), 192U);

  // at speed, with more listeners
  driver.pause(false);
  const ros::Subscriber again = listen("box/imu", late), fast = listen("box/fast", late);
  ASSERT_TRUE(NodeDriver::waitFor(
      [&] { return late["box/fast"].size() > 1000 && late["box/imu"].size() > 200; }));
  for (const std::string topic : {"box/imu", "box/imu/truth", "post/imu"})
    expectRight(early, topic);
  for (const std::string topic : {"box/imu", "box/fast"}) expectRight(late, topic);
  EXPECT_EQ(early["post/imu"].rbegin()->second.linear_acceleration.z, 9.80665);
  EXPECT_EQ(late["box/imu"].rbegin()->second.header.frame_id, "box/imu");
}

}  // namespace rigid_body_sim
