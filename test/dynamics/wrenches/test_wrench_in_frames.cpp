#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/wrench_in_frames.hpp>

#include "support/refusal.hpp"

namespace rigid_body_sim {
namespace {

const Vector3d kCom_B(0.3, -0.2, 0.1);
const Vector3d kForce(1.5, -2, 0.7);
const Vector3d kTorque(-0.4, 0.9, 2.1);
const Vector3d kPoint_B(0.6, 0.25, -0.5);

/// Its centre of mass lies off the origin and its principal axes are turned against the body's.
Body lopsided() {
  MassProperties properties;
  properties.mass = 2;
  properties.com_B = kCom_B;
  properties.I_Bcm << 1, 0.1, -0.2, 0.1, 1.5, 0.05, -0.2, 0.05, 2;
  return makeBody("lopsided", properties);
}

/// A world with another body before the lopsided one, and the lopsided one turned by R_WB.
struct WrenchInFrames : testing::Test {
  WrenchInFrames() {
    bodies = {makeBody("other", {1, Vector3d::Zero(), Matrix3d::Identity()}), lopsided()};
    BodyFrameMotion motion;
    motion.x_W = {4, 5, 6};
    motion.q_WB = Quaterniond(R_WB);
    states = {BodyState(), toBodyState(bodies[1], motion)};
  }

  /// Force and torque about the centre of mass are those, in world axes.
  void expectActs(const PointWrench& applied, const Vector3d& force_W, const Vector3d& torque_W) {
    ASSERT_EQ(applied.body, 1u);
    Wrench sum;
    addPointWrench(applied, states, sum);
    const Vector3d torque = sum.tau_W + rotate(states[1].q_WP, sum.tau_P);
    EXPECT_LT((sum.f_W - force_W).norm(), 1e-14);
    EXPECT_LT((torque - torque_W).norm(), 1e-14);
  }

  std::string refusal(std::size_t body, const Vector3d& force) const {
    return test::refusalOf([&] { wrenchInBodyAxes(bodies, body, force, kTorque, kPoint_B); });
  }

  const Matrix3d R_WB =
      Eigen::AngleAxisd(2.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  std::vector<Body> bodies;
  std::vector<BodyState> states;
};

TEST_F(WrenchInFrames, BodyAxesTurnWithTheBody) {
  expectActs(wrenchInBodyAxes(bodies, 1, kForce, kTorque, kPoint_B), R_WB * kForce,
             R_WB * ((kPoint_B - kCom_B).cross(kForce) + kTorque));
}

TEST_F(WrenchInFrames, WorldAxesStayWhileThePointMovesWithTheBody) {
  expectActs(wrenchInWorldAxes(bodies, 1, kForce, kTorque, kPoint_B), kForce,
             (R_WB * (kPoint_B - kCom_B)).cross(kForce) + kTorque);
}

TEST_F(WrenchInFrames, AForceAtTheCenterOfMassHasNoArm) {
  expectActs(wrenchAtCenterOfMass(bodies, 1, kForce, kTorque), kForce, kTorque);
}

TEST_F(WrenchInFrames, ActsFromTheStartOnForEver) {
  const PointWrench wrench = wrenchInBodyAxes(bodies, 1, kForce, kTorque, kPoint_B);
  EXPECT_EQ(wrench.start, 0);
  EXPECT_EQ(wrench.end, std::numeric_limits<double>::infinity());
}

TEST_F(WrenchInFrames, RefusesWhatCannotAct) {
  EXPECT_EQ(refusal(2, kForce), "a wrench needs a body: index must be below 2, got 2");
  EXPECT_EQ(refusal(1, {0, std::numeric_limits<double>::infinity(), 0}),
            "wrench on body 'lopsided': force must be finite, got [0, inf, 0]");
  bodies[1].fixed = true;
  EXPECT_EQ(refusal(1, kForce), "body 'lopsided' is fixed, no wrench can move it");
}

}  // namespace
}  // namespace rigid_body_sim
