#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/wrench_intake.hpp"
#include "support/lopsided_box.hpp"

namespace rigid_body_sim {
namespace {

/// Two bodies with their centres of mass off their origins, one fixed.
class WrenchMessages : public ::testing::Test {
 protected:
  using BodyWrench = geometry_msgs::WrenchStamped;

  WrenchInput take(const BodyWrench& message) { return intake.take("box", message, now); }
  WrenchInput take(const AppliedWrench& message) { return intake.take(message, origin, now); }

  template <class Message>
  std::string fault(const Message& message) {
    try {
      take(message);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "";
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

  BodyWrench onBody(const std::string& frame) const {
    BodyWrench message;
    message.header.frame_id = frame;
    message.wrench.force = toVector3(F);
    message.wrench.torque = toVector3(T);
    return message;
  }

  AppliedWrench applied(const std::string& frame) const {
    AppliedWrench message;
    message.header.frame_id = frame;
    message.body = "box";
    message.id = "a";
    message.wrench.force = toVector3(F);
    message.wrench.torque = toVector3(T);
    return message;
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
  WrenchIntake intake{scene, world.bodies, 0.5};
  TimeOrigin origin{ros::Time(1700000000, 500000000)};
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

TEST_F(WrenchMessages, TakesWorldAxesAtTheCentreOfMass) {
  const PointWrench taken = take(onBody("map")).wrench;
  EXPECT_EQ(force(taken), F);
  EXPECT_EQ(torque(taken), T);  // no lever at all, not even one of rounding
  EXPECT_TRUE(taken.at_center);
  EXPECT_FALSE(take(onBody("box")).wrench.at_center);
  EXPECT_FALSE(take(applied("map")).wrench.at_center);  // at the origin of the body
}

TEST_F(WrenchMessages, TakesBodyAxesAtTheBodyOrigin) {
  const PointWrench taken = take(onBody("box")).wrench;
  EXPECT_LE((force(taken) - q_WB * F).norm(), tolerance);
  EXPECT_LE((torque(taken) - q_WB * (T - com.cross(F))).norm(), tolerance);
}

TEST_F(WrenchMessages, TakesTheAxesOfANamedPointAtThatPoint) {
  const PointWrench taken = take(onBody("box/tip")).wrench;
  const Vector3d F_B = q_BF * F;
  const Vector3d arm_B = Vector3d(1, 0, 0) - com;
  EXPECT_LE((force(taken) - q_WB * F_B).norm(), tolerance);
  EXPECT_LE((torque(taken) - q_WB * (q_BF * T + arm_B.cross(F_B))).norm(), tolerance);
}

TEST_F(WrenchMessages, TakesAnyAxesAtAnyPointWhereBothAreNamed) {
  AppliedWrench message = applied("other");
  message.point_frame = "map";
  message.point = toPoint(Vector3d(5, 5, 5));
  const PointWrench taken = take(message).wrench;
  const Vector3d arm_W = Vector3d(5, 5, 5) - (Vector3d(1, 2, 3) + q_WB * com);
  EXPECT_LE((force(taken) - F).norm(), tolerance);  // `other` is not turned
  EXPECT_LE((torque(taken) - (T + arm_W.cross(F))).norm(), tolerance);
}

TEST_F(WrenchMessages, PutsThePointInTheBodyFrameByDefault) {
  AppliedWrench message = applied("map");
  message.point.x = 1;
  const PointWrench taken = take(message).wrench;
  const Vector3d arm_W = q_WB * (Vector3d(1, 0, 0) - com);
  EXPECT_LE((torque(taken) - (T + arm_W.cross(F))).norm(), tolerance);
}

TEST_F(WrenchMessages, HasOneSlotForEachFrameAndOneForEachId) {
  const std::string of_id = take(applied("map")).slot;
  AppliedWrench message = applied("box");
  EXPECT_EQ(take(message).slot, of_id);
  message.id = "map";
  EXPECT_NE(take(message).slot, of_id);
  EXPECT_NE(take(message).slot, take(onBody("map")).slot);
  EXPECT_NE(take(onBody("box")).slot, take(onBody("map")).slot);
  message.id = "";
  message.duration = ros::Duration(1);
  EXPECT_EQ(take(message).slot, "");
}

TEST_F(WrenchMessages, HoldsWhatHasNoDurationUntilTheTimeout) {
  EXPECT_EQ(take(onBody("map")).wrench.start, 4);
  EXPECT_EQ(take(onBody("map")).wrench.end, 4.5);
  EXPECT_EQ(take(applied("map")).wrench.end, 4.5);
  WrenchIntake for_ever(scene, world.bodies, 0);
  EXPECT_EQ(for_ever.take("box", onBody("map"), 4).wrench.end,
            std::numeric_limits<double>::infinity());
}

TEST_F(WrenchMessages, EndsADurationExactly) {
  AppliedWrench message = applied("map");
  message.duration = ros::Duration(2, 4910000);
  EXPECT_EQ(take(message).wrench.start, 4);
  EXPECT_EQ(take(message).wrench.end, 4 + 2.00491);
}

TEST_F(WrenchMessages, StartsNowWhatShouldHaveStartedAndLaterWhatIsToCome) {
  AppliedWrench message = applied("map");
  message.duration = ros::Duration(1);
  message.start = origin.stamp(3);
  EXPECT_EQ(take(message).wrench.start, 4);
  EXPECT_EQ(take(message).wrench.end, 5);
  message.start = ros::Time();
  EXPECT_EQ(take(message).wrench.start, 4);
  message.start = origin.stamp(7.25);
  EXPECT_EQ(take(message).wrench.start, 7.25);
  EXPECT_EQ(take(message).wrench.end, 8.25);
}

// it would never act: the run would go on without it, and say nothing
TEST_F(WrenchMessages, RefusesAStartOfAnotherClock) {
  AppliedWrench message = applied("map");
  message.duration = ros::Duration(1);
  message.start = origin.stamp(now + 3e7);
  EXPECT_EQ(take(message).wrench.start, now + 3e7);
  message.start = ros::Time(4200000000);
  EXPECT_EQ(fault(message).find("start must be at most 3e+07 s ahead of simulation time, got "
                                "4200000000.000000000, which is "),
            0U)
      << fault(message);
  EXPECT_NE(fault(message).find(" s ahead: of another clock?"), std::string::npos);
}

TEST_F(WrenchMessages, RefusesADurationThatIsNegativeOrNeedsAnId) {
  AppliedWrench message = applied("map");
  message.duration = ros::Duration(-1);
  EXPECT_EQ(fault(message), "duration must be >= 0 s, got -1");
  message.duration = ros::Duration();
  message.id = "";
  EXPECT_EQ(fault(message), "duration must be > 0 s where id is empty, got 0");
}

TEST_F(WrenchMessages, RefusesAnIdThatIsTooLongToKeep) {
  AppliedWrench message = applied("map");
  message.id = std::string(4096, 'a');
  EXPECT_EQ(fault(message), "");
  message.id += 'a';
  EXPECT_EQ(fault(message), "id must have at most 4096 bytes, got 4097");
}

TEST_F(WrenchMessages, RefusesNumbersThatAreNotFinite) {
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    BodyWrench on_body = onBody("box");
    on_body.wrench.force.y = bad;
    EXPECT_NE(fault(on_body).find("force must be finite"), std::string::npos);
    on_body = onBody("box");
    on_body.wrench.torque.z = bad;
    EXPECT_NE(fault(on_body).find("torque must be finite"), std::string::npos);
    AppliedWrench message = applied("box");
    message.point.x = bad;
    EXPECT_NE(fault(message).find("point must be finite"), std::string::npos);
  }
  AppliedWrench far = applied("box");
  far.wrench.force.x = 1e160;
  far.point.y = 1e160;
  EXPECT_NE(fault(far).find("the torque of the force must be finite"), std::string::npos);
}

TEST_F(WrenchMessages, RefusesWhatItDoesNotKnow) {
  EXPECT_NE(fault(onBody("")).find("unknown frame ''"), std::string::npos);
  EXPECT_NE(fault(applied("box/tail")).find("unknown frame 'box/tail'"), std::string::npos);
  AppliedWrench message = applied("map");
  message.body = "bxo";
  EXPECT_NE(fault(message).find("unknown body 'bxo'"), std::string::npos);
  message = applied("map");
  message.point_frame = "nowhere";
  EXPECT_NE(fault(message).find("'nowhere'"), std::string::npos);
}

TEST_F(WrenchMessages, OfAListAreTakenAsOneByOneAndNamedByTheirNumber) {
  std::vector<AppliedWrench> list{applied("map"), applied("box/tip")};
  list[1].id = "b";
  const std::vector<WrenchInput> taken = intake.take(list, origin, now);
  ASSERT_EQ(taken.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(taken[k].slot, take(list[k]).slot);
    EXPECT_EQ(taken[k].wrench.force, take(list[k]).wrench.force);
    EXPECT_EQ(taken[k].wrench.start, now);
  }
  EXPECT_TRUE(intake.take(std::vector<AppliedWrench>(), origin, now).empty());
  list[1].duration = ros::Duration(-1);
  try {
    intake.take(list, origin, now);
    FAIL();
  } catch (const std::invalid_argument& refused) {
    EXPECT_STREQ(refused.what(), "wrenches[1]: duration must be >= 0 s, got -1");
  }
}

TEST_F(WrenchMessages, RefusesAFrameThatDoesNotSayWhereOnTheBody) {
  EXPECT_EQ(fault(onBody("other")), "frame 'other' must be 'map' or fixed to body 'box'");
  EXPECT_EQ(fault(onBody("post")), "frame 'post' must be 'map' or fixed to body 'box'");
}

TEST_F(WrenchMessages, TakeTheFramesOfAPrefixAsThoseOfTheScene) {
  WrenchIntake with_prefix(scene, world.bodies, 0.5, "robot_1");
  for (const std::string frame : {"box", "box/tip"}) {
    const WrenchInput plain = take(onBody(frame));
    const WrenchInput prefixed = with_prefix.take("box", onBody("robot_1/" + frame), now);
    EXPECT_EQ(force(prefixed.wrench), force(plain.wrench)) << frame;
    EXPECT_EQ(torque(prefixed.wrench), torque(plain.wrench)) << frame;
  }
  EXPECT_THROW(with_prefix.take("box", onBody("robot_1/other"), now), std::invalid_argument);
  EXPECT_THROW(with_prefix.take("box", onBody("robot_2/box"), now), std::invalid_argument);
}

}  // namespace rigid_body_sim
