#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/wrench_intake.hpp"
#include "ros/inputs/wrench_messages.hpp"
#include "support/lopsided_box.hpp"

namespace rigid_body_sim {
namespace {

/// Two bodies with their centres of mass off their origins, one fixed.
class WrenchIntake : public ::testing::Test {
 protected:
  ResolvedWrench take(const WrenchRequest& request) const {
    return takeWrench(request, world.bodies, frames, rules, now);
  }

  /// Force and torque about the centre of mass [world axes] at the initial state.
  Vector3d force(const PointWrench& applied) const { return at(applied).f_W; }
  Vector3d torque(const PointWrench& applied) const {
    const Wrench wrench = at(applied);
    return wrench.tau_W + rotate(state.bodies[applied.body].q_WP, wrench.tau_P);
  }
  Wrench at(const PointWrench& applied) const {
    Wrench wrench;
    addPointWrench(applied, state.bodies, wrench);
    return wrench;
  }

  /// On <body>/wrench.
  WrenchRequest everyday(const std::string& frame) const {
    WrenchRequest request = general(frame);
    request.slot = "frame " + frame;
    request.placed_by_frame = true;
    return request;
  }
  /// On the topic `wrench`.
  WrenchRequest general(const std::string& frame) const {
    WrenchRequest request;
    request.slot = "id a";
    request.wrench.body = "box";
    request.wrench.frame = frame;
    request.wrench.force = F;
    request.wrench.torque = T;
    request.wrench.start = -std::numeric_limits<double>::infinity();
    return request;
  }

  const Scene scene = parseScene(R"(
world_frame: map
time_step: 0.01
bodies:
)" + test::kLopsidedBox + R"(    position: [1, 2, 3]
    orientation: [0.5, 0.5, 0.5, 0.5]
    points: {tip: {position: [1, 0, 0], orientation: [0, 0, 0.6, 0.8]}}
  - {name: other, shape: {sphere: {radius: 1}}, mass: 1}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 1, fixed: true}
)",
                                 "test");
  const World world = buildWorld(scene);
  const State state = initialState(scene, world);
  const FrameTable frames{scene, world.bodies};
  IntakeRules rules{"map", 0.5};
  double now = 4;

  const Vector3d F{1, -2, 3};
  const Vector3d T{0.5, 0.25, -1};
  const Quaterniond q_WB{0.5, 0.5, 0.5, 0.5};
  const Quaterniond q_BF{0.8, 0, 0, 0.6};
  const Vector3d com{0.3, -0.2, 0.1};
  // a few rotations of numbers below 4
  const double tolerance = 2e-14;
};

}  // namespace

TEST_F(WrenchIntake, TakesWorldAxesAtTheCentreOfMass) {
  const ResolvedWrench taken = take(everyday("map"));
  ASSERT_EQ(taken.fault, "");
  EXPECT_EQ(force(taken.wrench), F);
  EXPECT_EQ(torque(taken.wrench), T);  // no lever at all, not even one of rounding
}

TEST_F(WrenchIntake, TakesBodyAxesAtTheBodyOrigin) {
  const ResolvedWrench taken = take(everyday("box"));
  ASSERT_EQ(taken.fault, "");
  EXPECT_LE((force(taken.wrench) - q_WB * F).norm(), tolerance);
  EXPECT_LE((torque(taken.wrench) - q_WB * (T - com.cross(F))).norm(), tolerance);
}

TEST_F(WrenchIntake, TakesTheAxesOfANamedPointAtThatPoint) {
  const ResolvedWrench taken = take(everyday("box/tip"));
  ASSERT_EQ(taken.fault, "");
  const Vector3d F_B = q_BF * F;
  const Vector3d arm_B = Vector3d(1, 0, 0) - com;
  EXPECT_LE((force(taken.wrench) - q_WB * F_B).norm(), tolerance);
  EXPECT_LE((torque(taken.wrench) - q_WB * (q_BF * T + arm_B.cross(F_B))).norm(), tolerance);
}

TEST_F(WrenchIntake, TakesAnyAxesAtAnyPointThroughTheGeneralDoor) {
  WrenchRequest request = general("other");
  request.wrench.point_frame = "map";
  request.wrench.point = Vector3d(5, 5, 5);
  const ResolvedWrench taken = take(request);
  ASSERT_EQ(taken.fault, "");
  const Vector3d arm_W = Vector3d(5, 5, 5) - (Vector3d(1, 2, 3) + q_WB * com);
  EXPECT_LE((force(taken.wrench) - F).norm(), tolerance);  // `other` is not turned
  EXPECT_LE((torque(taken.wrench) - (T + arm_W.cross(F))).norm(), tolerance);
}

TEST_F(WrenchIntake, PutsThePointInTheBodyFrameByDefault) {
  WrenchRequest request = general("map");
  request.wrench.point = Vector3d(1, 0, 0);
  const ResolvedWrench taken = take(request);
  ASSERT_EQ(taken.fault, "");
  const Vector3d arm_W = q_WB * (Vector3d(1, 0, 0) - com);
  EXPECT_LE((torque(taken.wrench) - (T + arm_W.cross(F))).norm(), tolerance);
}

TEST_F(WrenchIntake, HoldsWhatHasNoDurationUntilTheTimeout) {
  EXPECT_EQ(take(everyday("map")).wrench.start, 4);
  EXPECT_EQ(take(everyday("map")).wrench.end, 4.5);
  EXPECT_EQ(take(general("map")).wrench.end, 4.5);
  rules.wrench_timeout = 0;
  EXPECT_EQ(take(everyday("map")).wrench.end, std::numeric_limits<double>::infinity());
}

TEST_F(WrenchIntake, EndsADurationExactly) {
  WrenchRequest request = general("map");
  request.wrench.duration = 2.00491;
  EXPECT_EQ(take(request).wrench.start, 4);
  EXPECT_EQ(take(request).wrench.end, 4 + 2.00491);
}

TEST_F(WrenchIntake, StartsNowWhatShouldHaveStartedAndLaterWhatIsToCome) {
  WrenchRequest request = general("map");
  request.wrench.duration = 1;
  request.wrench.start = 3;
  EXPECT_EQ(take(request).wrench.start, 4);
  EXPECT_EQ(take(request).wrench.end, 5);
  request.wrench.start = 7.25;
  EXPECT_EQ(take(request).wrench.start, 7.25);
  EXPECT_EQ(take(request).wrench.end, 8.25);
}

TEST_F(WrenchIntake, RefusesADurationThatIsNegativeOrNeedsAnId) {
  WrenchRequest request = general("map");
  request.wrench.duration = -1;
  EXPECT_EQ(take(request).fault, "duration must be >= 0 s, got -1");
  request.wrench.duration = 0;
  request.slot = "";
  EXPECT_EQ(take(request).fault, "duration must be > 0 s where id is empty, got 0");
}

TEST_F(WrenchIntake, RefusesAnIdThatIsTooLongToKeep) {
  WrenchRequest request = general("map");
  request.slot = slotOfId(std::string(4096, 'a'));
  EXPECT_EQ(take(request).fault, "");
  request.slot = slotOfId(std::string(4097, 'a'));
  EXPECT_EQ(take(request).fault, "id must have at most 4096 bytes, got 4097");
}

TEST_F(WrenchIntake, RefusesNumbersThatAreNotFinite) {
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    WrenchRequest request = everyday("box");
    request.wrench.force.y() = bad;
    EXPECT_NE(take(request).fault.find("force must be finite"), std::string::npos);
    request = everyday("box");
    request.wrench.torque.z() = bad;
    EXPECT_NE(take(request).fault.find("torque must be finite"), std::string::npos);
    request = general("box");
    request.wrench.point.x() = bad;
    EXPECT_NE(take(request).fault.find("point must be finite"), std::string::npos);
  }
}

TEST_F(WrenchIntake, RefusesWhatItDoesNotKnow) {
  EXPECT_NE(take(everyday("")).fault.find("unknown frame ''"), std::string::npos);
  EXPECT_NE(take(general("box/tail")).fault.find("unknown frame 'box/tail'"), std::string::npos);
  WrenchRequest request = general("map");
  request.wrench.body = "bxo";
  EXPECT_NE(take(request).fault.find("unknown body 'bxo'"), std::string::npos);
  request = general("map");
  request.wrench.point_frame = "nowhere";
  EXPECT_NE(take(request).fault.find("'nowhere'"), std::string::npos);
}

TEST_F(WrenchIntake, RefusesAFrameThatDoesNotSayWhereOnTheBody) {
  EXPECT_EQ(take(everyday("other")).fault, "frame 'other' must be 'map' or fixed to body 'box'");
  EXPECT_EQ(take(everyday("post")).fault, "frame 'post' must be 'map' or fixed to body 'box'");
}

}  // namespace rigid_body_sim
