#include <gtest/gtest.h>

#include "ros/inputs/wrench_intake.hpp"
#include "ros/mouse/mouse_spring.hpp"
#include "support/published_run.hpp"

/// What the node takes and publishes of a body on a pivot.
namespace rigid_body_sim {
namespace {

/// A rod of 2 kg that hangs from the middle of its upper end, at [1, 2, 3]; and a free ball.
Scene hangingRod() {
  return parseScene(R"(
time_step: 0.01
gravity: [0, 0, -10]
bodies:
  - {name: rod, shape: {box: [0.1, 0.2, 1]}, mass: 2, pivot: {point: [0, 0, 0.5]},
     position: [1, 2, 2.5], points: {end: {position: [0, 0, -0.5]}}}
  - {name: ball, shape: {sphere: {radius: 1}}, mass: 1}
wrenches:
  - {body: rod, frame: world, point: [0, 0, -0.5], force: [0, 0, -3], duration: 10}
)",
                    "test");
}

Vector3d forceOf(const geometry_msgs::WrenchStamped& message) {
  return fromVector3(message.wrench.force);
}

}  // namespace

TEST(PivotForce, IsPublishedOfBodiesOnAPivotAlone) {
  test::PublishedRun run(hangingRod(), 100);
  run.steps(3);
  EXPECT_EQ(run.published.names.count("rod/pivot_force"), 1U);
  EXPECT_EQ(run.published.names.count("ball/pivot_force"), 0U);
  const auto& messages = run.published.applied.at("rod/pivot_force");
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(messages.back().header.frame_id, "rod");
  EXPECT_EQ(messages.back().header.stamp,
            run.published.odometry.at("rod/odom").back().header.stamp);
  EXPECT_LT((forceOf(messages.back()) - Vector3d(0, 0, 23)).norm(), 1e-13);
  EXPECT_EQ(fromVector3(messages.back().wrench.torque), Vector3d::Zero());
}

// About the centre of mass, as of every body: the force acts half a metre below it.
TEST(AppliedWrench, OfABodyOnAPivotIsAboutItsCentreOfMass) {
  Scene scene = hangingRod();
  scene.wrenches[0].force = {4, 0, 0};
  test::PublishedRun run(scene, 100);
  run.outputs.publishDue();
  const auto& message = run.published.applied.at("rod/applied_wrench").back();
  EXPECT_LT((forceOf(message) - Vector3d(4, 0, 0)).norm(), 1e-15);
  EXPECT_LT((fromVector3(message.wrench.torque) - Vector3d(0, -2, 0)).norm(), 1e-15);
}

TEST(BodyWrench, InWorldAxesActsAtTheCentreOfMassOfABodyOnAPivot) {
  const Scene scene = hangingRod();
  const World world = buildWorld(scene);
  WrenchIntake intake(scene, world.bodies, 0, "");
  geometry_msgs::WrenchStamped message;
  message.header.frame_id = "world";
  message.wrench.force.x = 6;
  const PointWrench taken = intake.take("rod", message, 0).wrench;
  const Vector3d arm_W = armOf(taken, initialState(scene, world).bodies);
  EXPECT_LT((arm_W - Vector3d(0, 0, -0.5)).norm(), 1e-15);
}

// I/r² at the end of the rod along one of three directions that move, the third being infinite; and
// at the pivot a mass that is finite.
TEST(MouseSpring, FeelsTheInertiaAboutThePivot) {
  const Body body = buildWorld(hangingRod()).bodies[0];
  const Vector3d end_P = 2 * body.com_P;
  const double I_x = 2. / 12 * 1.04 + 0.5, I_y = 2. / 12 * 1.01 + 0.5;
  EXPECT_NEAR(massAtPoint(body, end_P), 3 / (1 / I_x + 1 / I_y), 1e-12);
  EXPECT_DOUBLE_EQ(massAtPoint(body, Vector3d::Zero()), 20);
}

}  // namespace rigid_body_sim
