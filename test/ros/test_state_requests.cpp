#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/node/state_requests.hpp"
#include "support/lopsided_box.hpp"

namespace rigid_body_sim {
namespace {

class StateRequests : public ::testing::Test {
 protected:
  SetState::Request request(const std::string& frame) const {
    SetState::Request r;
    r.body = "box";
    r.frame = frame;
    r.pose.position = toPoint({4, 5, 6});
    r.pose.orientation = toQuaternion(q_WB);
    r.twist.linear = toVector3(v);
    r.twist.angular = toVector3(w);
    return r;
  }

  std::string fault(const SetState::Request& r) const { return takeState(r, world, "map").fault; }

  GetState::Response tell(const State& state, const std::string& frame) const {
    GetState::Request r;
    r.body = "box";
    r.frame = frame;
    return tellState(r, world, state, "map");
  }

  const Scene scene = parseScene(R"(
world_frame: map
time_step: 0.01
bodies:
)" + test::kLopsidedBox + R"(  - {name: other, shape: {sphere: {radius: 1}}, mass: 1}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 1, fixed: true}
)",
                                 "test");
  const World world = buildWorld(scene);
  const Quaterniond q_WB{0.5, 0.5, -0.5, 0.5};
  const Vector3d v{1, -2, 3};
  const Vector3d w{0.5, 0.25, -1};
  const Vector3d com{0.3, -0.2, 0.1};
  // a few rotations of numbers below 10
  const double tolerance = 2e-14;
};

}  // namespace

TEST_F(StateRequests, TwistInWorldAxesIsThatOfTheBodyFrameOrigin) {
  const RequestedState taken = takeState(request("map"), world, "map");
  ASSERT_EQ(taken.fault, "");
  EXPECT_EQ(taken.body, 0U);
  const Vector3d arm_W = q_WB * com;
  EXPECT_LE((taken.state.x_W - (Vector3d(4, 5, 6) + arm_W)).norm(), tolerance);
  EXPECT_LE((taken.state.p_W / 2.0 - (v + w.cross(arm_W))).norm(), tolerance);
}

TEST_F(StateRequests, TwistInBodyAxesTurnsWithThePoseAskedFor) {
  const RequestedState taken = takeState(request("box"), world, "map");
  ASSERT_EQ(taken.fault, "");
  EXPECT_LE((taken.state.p_W / 2.0 - q_WB * (v + w.cross(com))).norm(), tolerance);
}

TEST_F(StateRequests, WhatIsSetIsToldInTheSameAxes) {
  for (const std::string& frame : {std::string("map"), std::string("box")}) {
    State state = initialState(scene, world);
    state.bodies[0] = takeState(request(frame), world, "map").state;
    const GetState::Response told = tell(state, frame);
    EXPECT_TRUE(told.success);
    EXPECT_LE((fromPoint(told.pose.position) - Vector3d(4, 5, 6)).norm(), tolerance);
    EXPECT_LE((fromVector3(told.twist.linear) - v).norm(), tolerance) << frame;
    EXPECT_LE((fromVector3(told.twist.angular) - w).norm(), tolerance) << frame;
    const geometry_msgs::Quaternion& q = told.pose.orientation;
    EXPECT_LE(angleBetween(Quaterniond(q.w, q.x, q.y, q.z), q_WB), tolerance);
  }
}

TEST_F(StateRequests, NormaliseAQuaternionThatIsUnitButForItsLastDigits) {
  SetState::Request r = request("map");
  r.pose.orientation = toQuaternion(Quaterniond(Eigen::Vector4d(q_WB.coeffs() * 1.0009)));
  const RequestedState taken = takeState(r, world, "map");
  ASSERT_EQ(taken.fault, "");
  EXPECT_NEAR(taken.state.q_WP.norm(), 1, 1e-15);
}

TEST_F(StateRequests, RefuseANormThatIsNotOne) {
  SetState::Request r = request("map");
  r.pose.orientation = toQuaternion(Quaterniond(Eigen::Vector4d(q_WB.coeffs() * 1.0011)));
  EXPECT_NE(fault(r).find("pose.orientation must be a unit quaternion"), std::string::npos);
  r.pose.orientation = geometry_msgs::Quaternion();
  EXPECT_EQ(fault(r), "pose.orientation must be a unit quaternion, got norm 0");
}

TEST_F(StateRequests, RefuseNumbersThatAreNotFinite) {
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    SetState::Request r = request("map");
    r.pose.position.y = bad;
    EXPECT_EQ(fault(r), "pose.position must be finite");
    r = request("map");
    r.pose.orientation.x = bad;
    EXPECT_NE(fault(r).find("pose.orientation"), std::string::npos);
    r = request("map");
    r.twist.linear.z = bad;
    EXPECT_EQ(fault(r), "twist.linear must be finite");
    r = request("map");
    r.twist.angular.x = bad;
    EXPECT_EQ(fault(r), "twist.angular must be finite");
  }
  SetState::Request r = request("map");
  r.twist.linear.x = 1.5e308;  // times 2 kg
  EXPECT_EQ(fault(r), "the state must have a finite momentum");
}

TEST_F(StateRequests, RefuseBodiesAndAxesThatAreNotKnown) {
  SetState::Request r = request("map");
  r.body = "bxo";
  EXPECT_EQ(fault(r), "unknown body 'bxo'");
  r.body = "post";
  EXPECT_EQ(fault(r), "body 'post' is fixed");
  EXPECT_EQ(fault(request("")), "frame must be 'map' or 'box', got ''");
  EXPECT_EQ(fault(request("other")), "frame must be 'map' or 'box', got 'other'");
  const GetState::Response told = tell(initialState(scene, world), "other");
  EXPECT_FALSE(told.success);
  EXPECT_EQ(told.message, "frame must be 'map' or 'box', got 'other'");
}

}  // namespace rigid_body_sim
