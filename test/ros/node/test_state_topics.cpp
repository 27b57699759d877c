#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/BodyStates.h>
#include <rigid_body_sim/GetState.h>
#include <rigid_body_sim/SetState.h>

#include "node_beside_core.hpp"

namespace rigid_body_sim {
namespace {

class StateTopics : public NodeBesideCore {
 protected:
  StateTopics() {
    const boost::function<void(const BodyStates&)> receive_states =
        [this](const BodyStates& message) { states = message; };
    const boost::function<void(const geometry_msgs::WrenchStamped&)> receive_wrench =
        [this](const geometry_msgs::WrenchStamped& message) { wrench = message; };
    subscribers.push_back(nh.subscribe<BodyStates>("rigid_body_node/states", 1000, receive_states));
    subscribers.push_back(
        nh.subscribe<geometry_msgs::WrenchStamped>("box/applied_wrench", 1000, receive_wrench));
    bool received = false;
    for (int i = 0; i < 1000 && !received; ++i) {
      stepBoth(1);
      received = NodeDriver::waitFor([this] { return receivedAll(); }, 0.05);
    }
    EXPECT_TRUE(received);
  }

  bool receivedAll() const {
    const ros::Time stamp = driver.odometry("box").header.stamp;
    return states.header.stamp == stamp && wrench.header.stamp == stamp;
  }

  void stepAndReceive(int steps) {
    stepBoth(steps);
    ASSERT_TRUE(NodeDriver::waitFor([this] { return receivedAll(); }));
  }

  void expectWrench(const Vector3d& f_B, const Vector3d& tau_B) const {
    // a few rotations of numbers below 100
    EXPECT_LT((fromVector3(wrench.wrench.force) - f_B).norm(), 1e-12);
    EXPECT_LT((fromVector3(wrench.wrench.torque) - tau_B).norm(), 1e-12);
  }

  BodyStates states;
  geometry_msgs::WrenchStamped wrench;
  std::vector<ros::Subscriber> subscribers;
  const Vector3d com{0.3, -0.2, 0.1};  // of box, as the scene has it
};

}  // namespace

TEST_F(StateTopics, StatesTellEveryBodyOfOneInstantAsOdometryDoes) {
  stepAndReceive(20);
  EXPECT_EQ(states.header.frame_id, "world");
  EXPECT_EQ(states.name, (std::vector<std::string>{"box", "canary", "post"}));
  ASSERT_EQ(states.pose.size(), 3U);
  ASSERT_EQ(states.twist.size(), 3U);
  for (std::size_t i : {0U, 1U}) {
    const nav_msgs::Odometry& odometry = driver.odometry(states.name[i]);
    EXPECT_EQ(states.header.stamp, odometry.header.stamp);
    EXPECT_EQ(states.pose[i], odometry.pose.pose);
    EXPECT_EQ(states.twist[i], odometry.twist.twist);
  }
  EXPECT_EQ(fromPoint(states.pose[2].position), Vector3d(5, 0, 0));
  EXPECT_EQ(fromVector3(states.twist[2].linear), Vector3d::Zero());
  EXPECT_EQ(fromVector3(states.twist[2].angular), Vector3d::Zero());
}

TEST_F(StateTopics, AppliedWrenchIsTheSumInBodyAxesAtTheCentreOfMass) {
  stepAndReceive(1);
  expectWrench(Vector3d::Zero(), Vector3d::Zero());  // gravity is not among it

  ApplyWrench call;
  call.request.wrench = generalMessage();  // world axes, at a point
  call.request.wrench.duration = ros::Duration(0.105);
  ASSERT_TRUE(ros::service::call("rigid_body_node/apply_wrench", call));
  call.request.wrench.id = "in body axes";
  call.request.wrench.header.frame_id = "box";
  ASSERT_TRUE(ros::service::call("rigid_body_node/apply_wrench", call));
  Isometry3d X_BF = Isometry3d::Identity();
  X_BF.translation() = point;
  reference.pushAtPoint("w", "box", F, T, point, {reference.time(), 0.105});
  reference.pushAtFrame("b", "box", F, T, X_BF, {reference.time(), 0.105});

  stepAndReceive(10);
  EXPECT_EQ(wrench.header.frame_id, "box");
  const Quaterniond q_BW = driver.motion("box").attitude.conjugate();
  const Vector3d f_B = q_BW * F + F;
  expectWrench(f_B, q_BW * T + T + (point - com).cross(f_B));

  stepAndReceive(1);  // past their end
  expectWrench(Vector3d::Zero(), Vector3d::Zero());
}

TEST_F(StateTopics, StateIsSetBetweenStepsAndGot) {
  SetState set;
  set.request.body = set.request.frame = "canary";
  set.request.pose.position = toPoint({1, 2, 3});
  set.request.pose.orientation = toQuaternion(Quaterniond(0.5, 0.5, 0.5, 0.5));
  set.request.twist.linear = toVector3({4, 5, 6});
  ASSERT_TRUE(ros::service::call("rigid_body_node/set_state", set));
  EXPECT_TRUE(set.response.success) << set.response.message;
  GetState get;
  get.request.body = "canary";
  get.request.frame = "world";
  ASSERT_TRUE(ros::service::call("rigid_body_node/get_state", get));
  EXPECT_TRUE(get.response.success) << get.response.message;
  EXPECT_EQ(get.response.stamp, driver.step(0));
  EXPECT_LT((fromPoint(get.response.pose.position) - Vector3d(1, 2, 3)).norm(), 1e-14);
  // the attitude takes x to y, y to z, z to x
  EXPECT_LT((fromVector3(get.response.twist.linear) - Vector3d(6, 4, 5)).norm(), 1e-14);

  // one step of 0.01 s on from there, under the scene's gravity
  driver.step(1);
  const Vector3d g(0.1, 0, -9.80665);
  const Vector3d expected = Vector3d(1, 2, 3) + 0.01 * Vector3d(6, 4, 5) + 0.5e-4 * g;
  EXPECT_LT((driver.motion("canary").position - expected).norm(), 1e-14);

  set.request.twist.linear.x = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(ros::service::call("rigid_body_node/set_state", set));
  EXPECT_FALSE(set.response.success);
  ASSERT_TRUE(ros::service::call("rigid_body_node/get_state", get));
  EXPECT_LT((fromPoint(get.response.pose.position) - expected).norm(), 1e-14);
}

}  // namespace rigid_body_sim
