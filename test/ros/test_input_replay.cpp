#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/input_messages.hpp"
#include "ros/inputs/input_replay.hpp"
#include "ros/inputs/inputs.hpp"
#include "ros/inputs/state_requests.hpp"
#include "ros/messages/conversions.hpp"
#include "support/lopsided_box.hpp"

namespace rigid_body_sim {
namespace {

const std::string kScene = R"(
gravity: [0, 0, -9.80665]
time_step: 0.01
medium: {density: 1.2, velocity: [1, 0, 0]}
bodies:
)" + test::kLopsidedBox + R"(    twist: {frame: world, linear: [1, -2, 3], angular: [0.5, -1, 2]}
  - {name: other, shape: {box: [1, 2, 3]}, mass: 1, drag: {linear: 0.1, quadratic: [0.1, 0.2, 0.3]},
     twist: {frame: world, linear: [0, 0, 0], angular: [0.1, 2, 0.1]}}
wrenches:
  - {body: other, frame: other, force: [1, 2, 3], start: 0.1234, duration: 3}
)";

Simulation simulationFrom(const std::string& yaml) {
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

  SetState::Request poseAndTwist() const {
    SetState::Request request;
    request.body = request.frame = "box";
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
    Simulation repeated = simulationFrom(kScene);
    for (std::int64_t step : {end, end + 340}) {
      stepTo(step);
      replayTo(step, replay, repeated);
      for (std::size_t i : {0U, 1U}) {
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
  std::string fault(const std::string& yaml = kScene) const {
    try {
      lastRun(inputs, simulationFrom(yaml).world(), "world");
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  Simulation run = simulationFrom(kScene);
  std::vector<Input> inputs;
  TimeOrigin origin{ros::Time(1000)};  // a wall clock
  Inputs node{{[] { return 1; },
               [this](const Input& message, const ros::Time&) { inputs.push_back(message); }},
              "world",
              run,
              origin,
              0};
};

}  // namespace

TEST_F(Recorded, RunIsRepeatedToTheLastBit) {
  wholeRun();
  EXPECT_EQ(inputs.size(), 14U);
  expectRepeated(replayOf(inputs), 60);
}

// a record made before states were recorded in world axes: the request as it was
TEST_F(Recorded, StateInBodyAxesIsReadFromAnOlderRecord) {
  wholeRun();
  Input& set = inputs[4];
  ASSERT_EQ(set.kind, Input::SET_STATE);
  EXPECT_EQ(set.frame, "world");
  const SetState::Request request = poseAndTwist();
  std::tie(set.frame, set.pose, set.twist) = std::tie(request.frame, request.pose, request.twist);
  expectRepeated(replayOf(inputs), 60);
}

TEST_F(Recorded, InputsThatRemainAtTheEndOfARunAreCounted) {
  wholeRun();
  InputReplay replay = replayOf(inputs);
  Simulation repeated = simulationFrom(kScene);
  EXPECT_EQ(replay.lastStep(), 50U);
  EXPECT_EQ(replay.remaining(), inputs.size());
  replayTo(45, replay, repeated);
  EXPECT_EQ(replay.remaining(), 4U);
  replayTo(51, replay, repeated);
  EXPECT_TRUE(replay.isDone());
}

TEST_F(Recorded, EveryInputChangesTheMotion) {
  wholeRun();
  stepTo(60);
  for (std::size_t left_out = 0; left_out < inputs.size(); ++left_out) {
    std::vector<Input> others = inputs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    for (std::size_t i = 0; i < others.size(); ++i) others[i].number = i;
    InputReplay replay = replayOf(others);
    Simulation repeated = simulationFrom(kScene);
    replayTo(60, replay, repeated);
    const bool same =
        run.body(0).x_W == repeated.body(0).x_W && run.body(1).x_W == repeated.body(1).x_W;
    // input 7, the reset, wipes out what came before it
    const bool wiped = left_out < 7;
    EXPECT_EQ(same, wiped) << "input " << left_out;
  }
}

TEST_F(Recorded, OnlyTheLastRunCounts) {
  push("a", 0, 0, 9);
  stepTo(7);
  node.apply(ResetInput{true});
  stepTo(3);
  push("b", 1, kWorld, 9);
  std::reverse(inputs.begin(), inputs.end());  // the order in a bag does not count
  EXPECT_EQ(inputs[0].run, 1U);
  EXPECT_EQ(inputs[2].run, 0U);
  InputReplay replay = replayOf(inputs);
  EXPECT_EQ(replay.size(), 2U);
  expectRepeated(replay, 60);
}

TEST_F(Recorded, RunFromALoadedStateIsRepeatedFromThere) {
  push("a", 0, 0, 9);
  stepTo(33);
  const State state = run.state();
  stepTo(50);
  node.apply(LoadInput{state});
  stepTo(40);
  push("b", 1, 0, 9);
  const InputReplay replay = replayOf(inputs);
  ASSERT_NE(replay.loaded(), nullptr);
  expectRepeated(replay, 60);
  inputs.back().kind = Input::LOAD;
  EXPECT_EQ(fault(), "input 1: a state is loaded at the start of a run only");
}

TEST_F(Recorded, NothingIsRecordedWithoutSubscribers) {
  std::size_t subscribers = 0;
  std::vector<Input> recorded;
  Inputs unheard({[&] { return subscribers; },
                  [&](const Input& message, const ros::Time&) { recorded.push_back(message); }},
                 "world", run, origin, 0);
  unheard.apply(ClearInput{});
  EXPECT_TRUE(recorded.empty());
  subscribers = 1;
  unheard.apply(ClearInput{});
  ASSERT_EQ(recorded.size(), 1U);
  EXPECT_EQ(recorded[0].number, 1U);  // so that a replay knows that one is missing
}

// rosbag closes a bag on a message that comes while its clock is at zero
TEST_F(Recorded, InputsAtTimeZeroAreRecordedOnceTheClockHasLeftIt) {
  std::vector<Input> recorded;
  const TimeOrigin zero;
  Inputs held({[] { return 1; },
               [&](const Input& message, const ros::Time&) { recorded.push_back(message); }},
              "world", run, zero, 0.02);
  const Inputs::Clock::time_point now;
  held.apply(ClearInput{});
  stepTo(5);
  held.apply(ResetInput{true});  // what came before belongs to another run
  held.apply(ClearInput{0, ""});
  held.recordHeld(now + std::chrono::seconds(1));
  EXPECT_TRUE(recorded.empty());
  stepTo(1);  // the clock is sent every other step
  held.recordHeld(now + std::chrono::seconds(2));
  held.recordHeld(now + std::chrono::seconds(3));
  EXPECT_TRUE(recorded.empty());
  stepTo(2);
  held.recordHeld(now + std::chrono::seconds(4));
  held.apply(ClearInput{1, ""});
  EXPECT_TRUE(recorded.empty());
  held.recordHeld(now + std::chrono::seconds(4) + Inputs::kClockDelay);
  ASSERT_EQ(recorded.size(), 3U);
  EXPECT_EQ(recorded[0].kind, Input::RESTART);
  EXPECT_EQ(recorded[0].step, 0U);
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    EXPECT_EQ(recorded[i].run, 1U);
    EXPECT_EQ(recorded[i].number, i);
  }
  EXPECT_EQ(recorded[2].step, 2U);
  held.apply(ClearInput{});
  EXPECT_EQ(recorded.size(), 4U);
}

TEST_F(Recorded, RunThatLacksAnInputIsRefused) {
  wholeRun();
  inputs.erase(inputs.begin() + 2);
  EXPECT_NE(fault().find("input 2 of the run is missing"), std::string::npos) << fault();
  inputs.erase(inputs.begin(), inputs.begin() + 2);
  EXPECT_NE(fault().find("input 0 of the run is missing"), std::string::npos) << fault();
}

TEST_F(Recorded, StepThatGoesBackIsRefused) {
  wholeRun();
  inputs[5].step = 20;  // after one at step 21
  inputs[5].time = 0.2;
  EXPECT_EQ(fault(),
            "input 5: was taken over after step 20, the one before after step 21: the record "
            "mixes runs or has been changed");
}

TEST_F(Recorded, RunOfAnotherSceneIsRefusedBeforeItBegins) {
  wholeRun();
  std::string other_step = kScene, other_body = kScene;
  other_step.replace(other_step.find("0.01"), 4, "0.02");
  EXPECT_NE(fault(other_step).find("input 1: was taken over after step 5 at 0.05"),
            std::string::npos)
      << fault(other_step);
  other_body.replace(other_body.find("name: box"), 9, "name: bxo");
  EXPECT_NE(fault(other_body).find("input 0: unknown body 'box'"), std::string::npos);
  inputs[3].kind = 200;
  EXPECT_EQ(fault(), "input 3: unknown kind of input 200");
}

}  // namespace rigid_body_sim
