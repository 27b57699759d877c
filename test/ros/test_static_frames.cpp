#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/static_frames.hpp"
#include "ros/messages/conversions.hpp"
#include "support/lopsided_box.hpp"

namespace rigid_body_sim {
namespace {

class StaticFramesTest : public ::testing::Test {
 protected:
  void hang(const std::string& child, const std::string& parent, const Isometry3d& X) {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(toTransform(X, parent, child, ros::Time(1)));
    statics.add(message);
  }

  static Isometry3d pose(const Vector3d& position, const Quaterniond& q) {
    Isometry3d X = Isometry3d::Identity();
    X.linear() = q.toRotationMatrix();
    X.translation() = position;
    return X;
  }

  const Scene scene = parseScene(R"(
time_step: 0.01
bodies:
)" + test::kLopsidedBox + R"(    points: {tip: {position: [1, 0, 0], orientation: [0, 0, 0.6, 0.8]}}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 1, position: [5, 0, 0], fixed: true}
)",
                                 "test");
  const World world = buildWorld(scene);
  FrameTable table{scene, world.bodies};
  StaticFrames statics;
  const Isometry3d X1 = pose({0.1, 0.2, 0.3}, {0.5, 0.5, 0.5, 0.5});
  const Isometry3d X2 = pose({-1, 0, 2}, {0.8, 0.6, 0, 0});
  // a few rotations of numbers below 10
  const double tolerance = 2e-14;
};

}  // namespace

TEST_F(StaticFramesTest, HangOnABodyByAChain) {
  hang("nozzle", "arm", X2);
  hang("arm", "box/tip", X1);
  statics.lookUp("nozzle", table);
  const FixedFrame* nozzle = table.find("nozzle");
  ASSERT_NE(nozzle, nullptr);
  EXPECT_EQ(nozzle->body, 0U);
  const Isometry3d expected = table.find("box/tip")->X_PF * X1 * X2;
  EXPECT_LE((nozzle->X_PF.matrix() - expected.matrix()).norm(), tolerance);
}

TEST_F(StaticFramesTest, HangOnTheWorldByABodyThatIsFixed) {
  hang("lamp", "post", X1);
  statics.lookUp("lamp", table);
  const FixedFrame* lamp = table.find("lamp");
  ASSERT_NE(lamp, nullptr);
  EXPECT_EQ(lamp->body, kWorld);
  EXPECT_LE((lamp->X_PF.translation() - Vector3d(5.1, 0.2, 0.3)).norm(), tolerance);
}

TEST_F(StaticFramesTest, StayAsTheyWereWhenFirstLookedUp) {
  hang("nozzle", "box", X1);
  statics.lookUp("nozzle", table);
  const Isometry3d first = table.find("nozzle")->X_PF;
  hang("nozzle", "box", X2);
  statics.lookUp("nozzle", table);
  EXPECT_TRUE(table.find("nozzle")->X_PF.isApprox(first, 0));
}

TEST_F(StaticFramesTest, LeaveOutWhatHangsOnNothingKnown) {
  hang("a", "b", X1);
  hang("b", "a", X1);  // a loop
  hang("c", "elsewhere", X1);
  for (const char* name : {"a", "b", "c", "elsewhere", "", "/box"}) {
    statics.lookUp(name, table);
    EXPECT_EQ(table.find(name), nullptr) << name;
  }
}

TEST_F(StaticFramesTest, DoNotMoveTheFramesOfTheScene) {
  const Isometry3d tip = table.find("box/tip")->X_PF;
  hang("box/tip", "post", X1);
  statics.lookUp("box/tip", table);
  EXPECT_EQ(table.find("box/tip")->body, 0U);
  EXPECT_TRUE(table.find("box/tip")->X_PF.isApprox(tip, 0));
}

TEST_F(StaticFramesTest, GoWithTheBodyOnWhichTheyHangAndComeAgainWithIt) {
  hang("nozzle", "box/tip", X1);
  hang("hook", "post", X2);
  for (const char* name : {"nozzle", "hook"}) statics.lookUp(name, table);
  const FixedFrame before = *table.find("nozzle");
  table.remove("post");
  EXPECT_FALSE(table.find("post"));
  EXPECT_FALSE(table.find("hook"));
  EXPECT_TRUE(table.find("nozzle"));
  table.remove("box");
  for (const char* name : {"box", "box/tip", "nozzle"}) EXPECT_FALSE(table.find(name)) << name;
  EXPECT_EQ(table.names(), "world");
  statics.lookUp("nozzle", table);
  EXPECT_FALSE(table.find("nozzle"));

  table.add(scene.bodies[0], world.bodies[0], 0);
  EXPECT_EQ(table.names(), "world, box, box/tip");
  statics.lookUp("nozzle", table);
  ASSERT_TRUE(table.find("nozzle"));
  EXPECT_EQ(table.find("nozzle")->body, 0U);
  EXPECT_EQ(table.find("nozzle")->X_PF.matrix(), before.X_PF.matrix());
}

}  // namespace rigid_body_sim
