#include <cmath>
#include <vector>

#include <geometry_msgs/Vector3Stamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/LawForces.h>

#include "node_driver.hpp"
#include "ros/messages/conversions.hpp"

/// Wind, pivots and tethers through the topics of the node.
namespace rigid_body_sim {
namespace {

class MediumTopics : public ::testing::Test {
 protected:
  MediumTopics() {
    driver.connect();
    const boost::function<void(const LawForces&)> keep_forces = [this](const LawForces& message) {
      forces = message;
    };
    const boost::function<void(const geometry_msgs::WrenchStamped&)> keep_pivot_force =
        [this](const geometry_msgs::WrenchStamped& message) { pivot_force = message; };
    subscribers = {
        nh.subscribe<LawForces>("rigid_body_node/law_forces", 100, keep_forces),
        nh.subscribe<geometry_msgs::WrenchStamped>("rod/pivot_force", 100, keep_pivot_force)};
  }

  ros::NodeHandle nh;
  NodeDriver driver{{"leaf", "rod", "weight"}};
  LawForces forces;
  geometry_msgs::WrenchStamped pivot_force;
  std::vector<ros::Subscriber> subscribers;
};

}  // namespace

// w − v decays by exp(−l t/m) with l/m = 1/s, whenever the wind has begun.
TEST_F(MediumTopics, TheWindBlowsFromItsMessageOn) {
  ros::Publisher wind = nh.advertise<geometry_msgs::Vector3Stamped>("rigid_body_node/wind", 1);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return wind.getNumSubscribers() > 0; }));
  geometry_msgs::Vector3Stamped message;
  message.header.frame_id = "world";
  message.vector.x = 3;
  wind.publish(message);
  const auto speed = [&] { return driver.odometry("leaf").twist.twist.linear.x; };
  for (int i = 0; i < 1000 && !(speed() > 0); ++i) driver.step(1);
  const double before = speed();
  ASSERT_GT(before, 0);
  driver.step(100);
  EXPECT_NEAR(3 - speed(), (3 - before) * std::exp(-1.0), 1e-12);
}

TEST_F(MediumTopics, ThePivotAndTheTetherBearTheirWeights) {
  const auto are_of_now = [this] {
    const ros::Time now = driver.odometry("rod").header.stamp;
    return forces.header.stamp == now && pivot_force.header.stamp == now;
  };
  // until the topics are connected
  for (int i = 0; i < 1000 && !NodeDriver::waitFor(are_of_now, 0.05); ++i) driver.step(1);
  ASSERT_TRUE(are_of_now());
  EXPECT_EQ(pivot_force.header.frame_id, "rod");
  EXPECT_LT((fromVector3(pivot_force.wrench.force) - Vector3d(0, 0, 20)).norm(), 1e-12);
  ASSERT_EQ(forces.forces.size(), 1U);
  const LawForce& tether = forces.forces[0];
  EXPECT_EQ(forces.header.frame_id, "world");
  EXPECT_EQ(tether.law, "tether");
  EXPECT_EQ(tether.from, "weight");
  EXPECT_EQ(tether.to, "");
  EXPECT_FALSE(tether.slack);
  EXPECT_NEAR(tether.tension, 40, 1e-8);
  EXPECT_NEAR(tether.length, 1.04, 1e-11);
}

}  // namespace rigid_body_sim
