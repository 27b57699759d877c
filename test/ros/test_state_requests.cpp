#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/state_requests.hpp"
#include "ros/messages/conversions.hpp"
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

  StateInput taken(const SetState::Request& r) const { return takeState(r, world, "map"); }

  BodyState stateOf(const SetState::Request& r) const {
    return toBodyState(world.bodies[0], taken(r).motion);
  }

  std::string fault(const SetState::Request& r) const {
    try {
      taken(r);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "";
  }

  GetState::Response report(const State& state, const std::string& frame) const {
    GetState::Request r;
    r.body = "box";
    r.frame = frame;
    return reportState(r, world, state, "map");
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
  EXPECT_EQ(taken(request("map")).body, 0U);
  const BodyState state = stateOf(request("map"));
  const Vector3d arm_W = q_WB * com;
  EXPECT_LE((state.x_W - (Vector3d(4, 5, 6) + arm_W)).norm(), tolerance);
  EXPECT_LE((state.p_W / 2.0 - (v + w.cross(arm_W))).norm(), tolerance);
}

TEST_F(StateRequests, TwistInBodyAxesTurnsWithThePoseAskedFor) {
  const BodyState state = stateOf(request("box"));
  EXPECT_LE((state.p_W / 2.0 - q_WB * (v + w.cross(com))).norm(), tolerance);
}

TEST_F(StateRequests, WhatIsSetIsReportedInTheSameAxes) {
  for (const std::string& frame : {std::string("map"), std::string("box")}) {
    State state = initialState(scene, world);
    state.bodies[0] = stateOf(request(frame));
    const GetState::Response reported = report(state, frame);
    EXPECT_TRUE(reported.success);
    EXPECT_LE((fromPoint(reported.pose.position) - Vector3d(4, 5, 6)).norm(), tolerance);
    EXPECT_LE((fromVector3(reported.twist.linear) - v).norm(), tolerance) << frame;
    EXPECT_LE((fromVector3(reported.twist.angular) - w).norm(), tolerance) << frame;
    const geometry_msgs::Quaternion& q = reported.pose.orientation;
    EXPECT_LE(angleBetween(Quaterniond(q.w, q.x, q.y, q.z), q_WB), tolerance);
  }
}

TEST_F(StateRequests, NormaliseAQuaternionThatIsUnitButForItsLastDigits) {
  SetState::Request r = request("map");
  r.pose.orientation = toQuaternion(Quaterniond(Eigen::Vector4d(q_WB.coeffs() * 1.0009)));
  EXPECT_NEAR(taken(r).motion.q_WB.norm(), 1, 1e-15);
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
    EXPECT_NE(fault(r).find("pose.position must be finite, got ["), std::string::npos);
    r = request("map");
    r.pose.orientation.x = bad;
    EXPECT_NE(fault(r).find("pose.orientation"), std::string::npos);
    r = request("map");
    r.twist.linear.z = bad;
    EXPECT_NE(fault(r).find("twist.linear must be finite"), std::string::npos);
    r = request("map");
    r.twist.angular.x = bad;
    EXPECT_NE(fault(r).find("twist.angular must be finite"), std::string::npos);
  }
  SetState::Request r = request("map");
  r.twist.linear.x = 1.5e308;  // times 2 kg
  EXPECT_EQ(fault(r), "the state must have a finite momentum");
}

TEST_F(StateRequests, RefuseBodiesAndAxesThatAreNotKnown) {
  SetState::Request r = request("map");
  r.body = "bxo";
  EXPECT_EQ(fault(r), "unknown body 'bxo' (known: box, other, post)");
  r.body = "post";
  EXPECT_EQ(fault(r), "body 'post' is fixed");
  const std::string refusal =
      "frame must be that of the world, 'map' or 'world', or of the body, 'box' or 'body', got ";
  EXPECT_EQ(fault(request("")), refusal + "''");
  EXPECT_EQ(fault(request("other")), refusal + "'other'");
  EXPECT_THROW(report(initialState(scene, world), "other"), std::invalid_argument);
}

TEST_F(StateRequests, TakeTheWordsOfASceneForTheAxesToo) {
  EXPECT_EQ(stateOf(request("world")).p_W, stateOf(request("map")).p_W);
  EXPECT_EQ(stateOf(request("body")).p_W, stateOf(request("box")).p_W);
  const State state = initialState(scene, world);
  EXPECT_EQ(report(state, "world").twist, report(state, "map").twist);
  EXPECT_EQ(report(state, "body").twist, report(state, "box").twist);
}

// A client that takes child_frame_id from odometry, or a name from tf, need not know the prefix.
TEST_F(StateRequests, TakeTheFrameOnTfForTheAxesOfTheBody) {
  const std::vector<std::string> frames = {"two/box", "two/post"};
  const State state = initialState(scene, world);
  GetState::Request asked;
  asked.body = "box";
  asked.frame = "two/box";
  EXPECT_EQ(reportState(asked, world, state, "map", frames).twist, report(state, "box").twist);
  EXPECT_EQ(takeState(request("two/box"), world, "map", frames).motion.v_W,
            taken(request("box")).motion.v_W);
  EXPECT_THROW(takeState(request("two/post"), world, "map", frames), std::invalid_argument);
}

TEST_F(StateRequests, RefuseAWordThatIsTheNameOfAnotherBody) {
  World other = world;
  other.bodies[1].name = "body";
  EXPECT_THROW(takeState(request("body"), other, "map"), std::invalid_argument);
  SetState::Request r = request("body");
  r.body = "body";
  EXPECT_EQ(takeState(r, other, "map").body, 1U);
}

// a record of ~inputs holds what was taken, and is taken once more when it is replayed
TEST_F(StateRequests, WhatWasTakenIsTakenAgainToTheLastBit) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 10000; ++i) {
    SetState::Request r = request("box");
    const Eigen::Vector4d q =
        Eigen::Vector4d(normal(random), normal(random), normal(random), normal(random))
            .normalized();
    r.pose.orientation =
        toQuaternion(Quaterniond(Eigen::Vector4d(q * (1 + 1e-4 * normal(random)))));
    const BodyFrameMotion first = taken(r).motion;
    r.frame = "map";
    r.pose = toPose(first);
    r.twist.linear = toVector3(first.v_W);
    r.twist.angular = toVector3(first.w_W);
    const BodyFrameMotion again = taken(r).motion;
    ASSERT_EQ(first.q_WB.coeffs(), again.q_WB.coeffs()) << i;
    ASSERT_EQ(first.x_W, again.x_W);
    ASSERT_EQ(first.v_W, again.v_W);
    ASSERT_EQ(first.w_W, again.w_W);
  }
}

}  // namespace rigid_body_sim
