#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/mouse/mouse.hpp"

namespace rigid_body_sim {
namespace {

using Feedback = visualization_msgs::InteractiveMarkerFeedback;

constexpr double kTimeout = 0.5;

/// A box, its centre of mass off its origin, that flies and turns; and a fixed post.
class MouseTest : public ::testing::Test {
 protected:
  Feedback feedback(int event) const {
    Feedback message;
    message.header.frame_id = message.marker_name = "box";
    message.header.stamp = origin.stamp(simulation.time());
    message.client_id = "rviz";
    message.event_type = static_cast<Feedback::_event_type_type>(event);
    message.pose.orientation.w = 1;
    message.mouse_point = toPoint(point_B);
    message.mouse_point_valid = event == Feedback::MOUSE_DOWN;
    return message;
  }

  Feedback dragged(const Vector3d& by_B) const {
    Feedback message = feedback(Feedback::POSE_UPDATE);
    message.pose.position = toPoint(by_B);
    return message;
  }

  void step(int steps = 1) {
    for (int i = 0; i < steps; ++i) {
      mouse.pull();
      simulation.step();
    }
  }

  Isometry3d pose() const {
    const BodyFrameMotion motion =
        toBodyFrameMotion(simulation.world().bodies[0], simulation.body(0));
    return Eigen::Translation3d(motion.x_W) * motion.q_WB;
  }

  /// The pull that is to act during the next step; none is a force of zero.
  PointWrench pullNow() {
    mouse.pull();
    Simulation next = simulation;
    next.step();
    EXPECT_LE(next.activeWrenches(0).size(), 1U);
    return next.activeWrenches(0).empty() ? PointWrench() : next.activeWrenches(0)[0];
  }

  /// Expects the pull of a spring from the point pressed to a goal.
  void expectPullTo(const Vector3d& goal_W) {
    const Body& body = simulation.world().bodies[0];
    const MouseSpring spring{0, body.X_BP.inverse() * point_B, goal_W};
    const PointWrench expected = pullOf(spring, body, simulation.body(0), 0.01);
    const PointWrench pull = pullNow();
    EXPECT_EQ(pull.point, expected.point);
    EXPECT_LT((pull.force - expected.force).norm(), 1e-12 * (1 + expected.force.norm()));
  }

  const Scene scene = parseScene(R"(
time_step: 0.01
bodies:
  - name: box
    mass: 2.0
    inertia: {ixx: 1.0, iyy: 1.5, izz: 2.0}
    center_of_mass: [0.3, -0.2, 0.1]
    orientation: [0.5, 0.5, 0.5, 0.5]
    twist: {frame: world, linear: [1, 0, 0], angular: [0, 0, 1]}
  - name: post
    shape: {sphere: {radius: 1}}
    mass: 1.0
    fixed: true
)",
                                 "test");
  const Vector3d point_B{0.5, 0.4, -0.3};
  TimeOrigin origin{ros::Time(1000, 0)};
  World world = buildWorld(scene);
  State initial = initialState(scene, world);
  Simulation simulation{world, initial};
  Inputs inputs{{[] { return false; }, {}, {}},
                "world",
                simulation,
                origin,
                0,
                [this](const SimulationInput& input) { mouse.follow(input); }};
  Mouse mouse{simulation, inputs, kTimeout};
};

}  // namespace

TEST_F(MouseTest, PressedPointIsPulledToWhereItWasInTheWorld) {
  EXPECT_EQ(mouse.take(feedback(Feedback::MOUSE_DOWN)), "");
  const Vector3d goal_W = pose() * point_B;
  expectPullTo(goal_W);
  step(10);
  expectPullTo(goal_W);
}

TEST_F(MouseTest, DraggedHandleTakesTheGoalAlongInTheFrameOfItsStamp) {
  mouse.take(feedback(Feedback::MOUSE_DOWN));
  step(5);
  const Feedback late = dragged(Vector3d(0.1, 0.2, 0.3));
  const Vector3d goal_W = pose() * (point_B + Vector3d(0.1, 0.2, 0.3));
  step(5);
  EXPECT_EQ(mouse.take(late), "");
  expectPullTo(goal_W);
}

TEST_F(MouseTest, WithoutAMousePointTheCentreOfMassIsHeld) {
  Feedback press = feedback(Feedback::MOUSE_DOWN);
  press.mouse_point_valid = false;
  mouse.take(press);
  EXPECT_LT(pullNow().point.norm(), 1e-15);
}

TEST_F(MouseTest, HoldsTheSamePointOfABodyWhoseMassPropertiesChange) {
  mouse.take(feedback(Feedback::MOUSE_DOWN));
  const Vector3d goal_W = pose() * point_B;
  step(5);
  const Vector3d moments(3, 2, 2.5);
  inputs.apply(MassInput{0, {5, {-0.4, 0.3, 0.6}, moments.asDiagonal()}});
  expectPullTo(goal_W);
}

TEST_F(MouseTest, ABodyThatLeavesIsLetGoAndCannotBePressed) {
  mouse.take(feedback(Feedback::MOUSE_DOWN));
  step();
  inputs.apply(PresenceInput{0, std::nullopt});
  step();
  EXPECT_EQ(simulation.wrenchCount(), 0U);
  EXPECT_EQ(mouse.take(feedback(Feedback::MOUSE_DOWN)), "body 'box' is absent");
  EXPECT_EQ(mouse.take(dragged(Vector3d(1, 0, 0))), "body 'box' is absent");
}

TEST_F(MouseTest, ReleaseEndsThePullAtOnce) {
  mouse.take(feedback(Feedback::MOUSE_DOWN));
  mouse.take(dragged(Vector3d(1, 0, 0)));
  step();
  EXPECT_EQ(simulation.activeWrenches(0).size(), 1U);
  EXPECT_EQ(mouse.take(feedback(Feedback::MOUSE_UP)), "");
  EXPECT_EQ(simulation.wrenchCount(), 0U);
  const Vector3d p_W = simulation.body(0).p_W;
  step(10);
  EXPECT_EQ(simulation.body(0).p_W, p_W);
  // and what a viewer still sends moves nothing
  EXPECT_EQ(mouse.take(dragged(Vector3d(1, 0, 0))), "");
  step();
  EXPECT_EQ(simulation.wrenchCount(), 0U);
}

TEST_F(MouseTest, PullTimesOutExactlyAndComesBackWithFeedback) {
  mouse.take(feedback(Feedback::MOUSE_DOWN));
  mouse.take(dragged(Vector3d(1, 0, 0)));
  step();
  EXPECT_EQ(simulation.activeWrenches(0).at(0).end, kTimeout);
  step(60);
  EXPECT_EQ(simulation.wrenchCount(), 0U);
  Feedback alive = dragged(Vector3d(1, 0, 0));
  alive.event_type = Feedback::KEEP_ALIVE;
  mouse.take(alive);
  step();
  EXPECT_EQ(simulation.wrenchCount(), 1U);
}

TEST_F(MouseTest, BodyIsHeldByTheViewerThatPressedLast) {
  mouse.take(feedback(Feedback::MOUSE_DOWN));
  Feedback other = feedback(Feedback::MOUSE_DOWN);
  other.client_id = "other";
  mouse.take(other);
  const Vector3d goal_W = pose() * point_B;
  mouse.take(dragged(Vector3d(1, 0, 0)));
  expectPullTo(goal_W);
  mouse.take(feedback(Feedback::MOUSE_UP));
  expectPullTo(goal_W);
}

TEST_F(MouseTest, BodyThatIsClearedOrResetIsNotPulledUntilPressedAgain) {
  for (const SimulationInput& input :
       {SimulationInput(ClearInput{0, ""}), SimulationInput(ClearInput{}),
        SimulationInput(ResetInput{})}) {
    mouse.take(feedback(Feedback::MOUSE_DOWN));
    step();
    EXPECT_EQ(simulation.wrenchCount(), 1U);
    inputs.apply(input);
    mouse.take(dragged(Vector3d(1, 0, 0)));
    step();
    EXPECT_EQ(simulation.wrenchCount(), 0U);
  }
  mouse.take(feedback(Feedback::MOUSE_DOWN));
  inputs.apply(ClearInput{1, ""});
  inputs.apply(ClearInput{0, "id of another"});
  step();
  EXPECT_EQ(simulation.wrenchCount(), 1U);
}

TEST_F(MouseTest, BodyThatIsRemovedIsLetGoAndCannotBeHeldUntilItIsAddedAgain) {
  mouse.take(feedback(Feedback::MOUSE_DOWN));
  step();
  EXPECT_EQ(simulation.wrenchCount(), 1U);
  mouse.remove(0);
  EXPECT_EQ(simulation.wrenchCount(), 0U);
  EXPECT_EQ(mouse.take(feedback(Feedback::MOUSE_DOWN)), "unknown handle 'box'");
  step();
  EXPECT_EQ(simulation.wrenchCount(), 0U);
  mouse.add(0);
  EXPECT_EQ(mouse.take(feedback(Feedback::MOUSE_DOWN)), "");
  step();
  EXPECT_EQ(simulation.wrenchCount(), 1U);
}

TEST_F(MouseTest, RefuseWhatBreaksARuleAndKeepWhatWas) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Feedback bad = feedback(Feedback::MOUSE_DOWN);
  bad.mouse_point.x = kNaN;
  EXPECT_EQ(mouse.take(bad), "feedback on handle 'box' must make a finite pull");
  bad = feedback(Feedback::MOUSE_DOWN);
  bad.marker_name = bad.header.frame_id = "post";  // fixed
  EXPECT_EQ(mouse.take(bad), "unknown handle 'post'");
  bad = feedback(Feedback::MOUSE_DOWN);
  bad.header.frame_id = "world";
  EXPECT_EQ(mouse.take(bad), "feedback on handle 'box' must be in frame 'box', got 'world'");
  step();
  EXPECT_EQ(simulation.wrenchCount(), 0U);

  mouse.take(feedback(Feedback::MOUSE_DOWN));
  const Vector3d goal_W = pose() * point_B;
  for (double x : {kNaN, std::numeric_limits<double>::infinity(), 1e308})
    EXPECT_NE(mouse.take(dragged(Vector3d(x, 0, 0))), "") << x;
  expectPullTo(goal_W);
}

TEST_F(MouseTest, LetGoABodyWhosePullTheSimulationRefuses) {
  PointWrench later;
  later.start = 1e3;
  later.end = 2e3;
  for (std::size_t i = 0; i < Simulation::kMaxWrenches; ++i) simulation.applyWrench("", later);
  EXPECT_EQ(mouse.take(feedback(Feedback::MOUSE_DOWN)), "");
  EXPECT_EQ(mouse.pull(), "body 'box' is let go: at most 100000 wrenches may act or be to come");
  EXPECT_EQ(mouse.pull(), "");
}

TEST(PoseHistory, GivesThePoseAtOrBeforeAStampOfTheLastTenSeconds) {
  PoseHistory history;
  const auto pose = [](double x) { return Isometry3d(Eigen::Translation3d(x, 0, 0)); };
  const auto x = [&](double t) { return history.at(ros::Time(t)).translation().x(); };
  for (int i = 0; i <= 3000; ++i) history.add(ros::Time(10 + 0.01 * i), pose(i));
  EXPECT_EQ(x(37.505), 2750);
  EXPECT_EQ(x(0), 3000);  // the newest
  EXPECT_EQ(x(100), 3000);
  EXPECT_NEAR(x(1), 2000, 1);  // the oldest that is left
}

}  // namespace rigid_body_sim
