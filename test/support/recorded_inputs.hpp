#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/wrench_in_frames.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/input_messages.hpp"
#include "ros/inputs/input_replay.hpp"
#include "ros/inputs/inputs.hpp"
#include "ros/inputs/state_requests.hpp"
#include "ros/messages/conversions.hpp"
#include "support/lopsided_box.hpp"

/// Runs that are changed from outside, with what the node records of them.
namespace rigid_body_sim::test {

inline const std::string kRecordedScene = R"(
gravity: [0, 0, -9.80665]
time_step: 0.01
medium: {density: 1.2, velocity: [1, 0, 0]}
bodies:
)" + kLopsidedBox + R"(    twist: {frame: world, linear: [1, -2, 3], angular: [0.5, -1, 2]}
  - {name: other, shape: {box: [1, 2, 3]}, mass: 1, drag: {linear: 0.1, quadratic: [0.1, 0.2, 0.3]},
     twist: {frame: world, linear: [0, 0, 0], angular: [0.1, 2, 0.1]}}
  - {name: guest, shape: {box: [1, 2, 3]}, mass: 1, absent: true}
wrenches:
  - {body: other, frame: other, force: [1, 2, 3], start: 0.1234, duration: 3}
)";

inline Simulation simulationFrom(const std::string& yaml) {
  const Scene scene = parseScene(yaml, "test");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

/// A run that is changed in every way there is, and what the node records of it.
class Recorded : public ::testing::Test {
 protected:
  void stepTo(std::int64_t step) {
    while (run.steps() < step) run.step();
  }

  void push(const std::string& slot, std::size_t body, std::size_t axes, double end) {
    PointWrench wrench;
    wrench.body = wrench.point_frame = body;
    wrench.axes = axes;
    wrench.force = Vector3d(1, 1.0 / 3, -0.7);
    wrench.torque = Vector3d(0.1, -0.2, 0.3);
    wrench.point = Vector3d(0.3, 0.1, 1.0 / 7);
    wrench.start = run.time() + 0.00317;
    wrench.end = end;
    node.apply(WrenchInput{slot, wrench});
  }

  SetState::Request poseAndTwist(const std::string& body = "box") const {
    SetState::Request request;
    request.body = request.frame = body;
    request.pose.position = toPoint(Vector3d(1, 2, 3));
    request.pose.orientation = toQuaternion(Quaterniond(0.1, 0.7, 0.5, 0.5));
    request.twist.linear = toVector3(Vector3d(0.1, 0.2, 0.3));
    request.twist.angular = toVector3(Vector3d(1, -2, 1.0 / 3));
    return request;
  }

  void wholeRun() {
    push("", 0, 0, 0.20491);
    stepTo(5);
    push("a", 0, kWorld, std::numeric_limits<double>::infinity());
    push("b", 1, 0, 9);  // axes of another body: couples the two
    stepTo(17);
    node.apply(ClearInput{0, "a"});
    stepTo(21);
    node.apply(takeState(poseAndTwist(), run.world(), "world"));
    stepTo(30);
    node.apply(ClearInput{});
    push("c", 0, kWorld, 1);
    stepTo(40);
    node.apply(ResetInput{false});
    push("d", 0, 0, 9);
    push("e", 1, 1, 9);
    stepTo(45);
    node.apply(ClearInput{1, ""});
    push("e", 1, 1, 9);
    stepTo(50);
    node.apply(ClearInput{ClearInput::kEveryBody, "e"});
    node.apply(WindInput{Vector3d(0.1, -2, 1.0 / 3)});
    PointWrench at_center = wrenchAtCenterOfMass(run.world().bodies, 0, {1, 2, 0.3}, {0, 0.1, 0});
    at_center.start = run.time();
    node.apply(WrenchInput{"f", at_center});
    MassProperties heavier{2.7, {0.1, -1.0 / 3, 0.2}, Matrix3d::Zero()};
    heavier.I_Bcm << 1.1, 0.1, -0.2, 0.1, 1.4, 1.0 / 7, -0.2, 1.0 / 7, 1.9;
    node.apply(MassInput{0, heavier});
    const BodyFrameMotion guest = takeState(poseAndTwist("guest"), run.world(), "world").motion;
    node.apply(PresenceInput{2, guest});
    node.apply(PresenceInput{2, std::nullopt});
    node.apply(PresenceInput{2, guest});
  }

  InputReplay replayOf(const std::vector<Input>& messages) const {
    return InputReplay(lastRun(messages, run.world(), "world"));
  }

  void replayTo(std::int64_t step, InputReplay& replay, Simulation& repeated) const {
    while (repeated.steps() < step) {
      replay.applyDue(repeated);
      repeated.step();
    }
  }

  void expectRepeated(InputReplay replay, std::int64_t end) {
    Simulation repeated = simulationFrom(kRecordedScene);
    for (std::int64_t step : {end, end + 340}) {
      stepTo(step);
      replayTo(step, replay, repeated);
      for (std::size_t i : {0U, 1U, 2U}) {
        const BodyState& a = run.body(i);
        const BodyState& b = repeated.body(i);
        EXPECT_EQ(a.x_W, b.x_W);
        EXPECT_EQ(a.q_WP.coeffs(), b.q_WP.coeffs());
        EXPECT_EQ(a.p_W, b.p_W);
        EXPECT_EQ(a.L_W, b.L_W);
      }
    }
  }

  /// Why a record is refused.
  std::string fault(const std::string& yaml = kRecordedScene) const {
    try {
      lastRun(inputs, simulationFrom(yaml).world(), "world");
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  Simulation run = simulationFrom(kRecordedScene);
  std::vector<Input> inputs;
  TimeOrigin origin{ros::Time(1000)};  // a wall clock
  Inputs node{{[] { return 1; },
               [this](const Input& message, const ros::Time&) { inputs.push_back(message); }},
              "world",
              run,
              origin,
              0};
};

}  // namespace rigid_body_sim::test
