#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <rosgraph_msgs/Log.h>
#include <tf2_ros/transform_listener.h>

#include "node_driver.hpp"

namespace rigid_body_sim {

TEST(Reset, RaisesNoWarningAboutTfWhileTimeRunsOn) {
  NodeDriver driver({"box", "canary"});
  driver.connect();
  ros::NodeHandle nh;
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer);
  std::vector<std::string> warnings;
  const boost::function<void(const rosgraph_msgs::Log&)> receive =
      [&](const rosgraph_msgs::Log& log) {
        if (log.level >= rosgraph_msgs::Log::WARN) warnings.push_back(log.name + ": " + log.msg);
      };
  const ros::Subscriber rosout = nh.subscribe<rosgraph_msgs::Log>("/rosout", 1000, receive);
  const ros::Publisher wrench = nh.advertise<geometry_msgs::WrenchStamped>("box/wrench", 1);

  driver.pause(false);
  for (int i = 0; i < 20; ++i) {
    const std::size_t received = driver.stamps().size();
    ASSERT_TRUE(NodeDriver::waitFor([&] { return driver.stamps().size() > received + 3; }));
    driver.reset();
  }
  driver.pause(true);
  const ros::Time last = driver.step(1);
  ASSERT_TRUE(NodeDriver::waitFor(
      [&] { return buffer.canTransform("world", "box", last) || !warnings.empty(); }));
  for (std::size_t i = 1; i < driver.stamps().size(); ++i)
    ASSERT_LT(driver.stamps()[i - 1], driver.stamps()[i]) << "message " << i;

  // the log is received, and has come so far: a wrench that is refused is the only warning
  ASSERT_TRUE(NodeDriver::waitFor([&] {
    wrench.publish(geometry_msgs::WrenchStamped());
    return !warnings.empty();
  }));
  for (const std::string& warning : warnings)
    EXPECT_NE(warning.find("wrench refused"), std::string::npos) << warning;
}

}  // namespace rigid_body_sim
