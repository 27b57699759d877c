#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/input_messages.hpp"
#include "ros/inputs/input_replay.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/node/state_requests.hpp"
#include "support/lopsided_box.hpp"

namespace rigid_body_sim {
namespace {

const std::string kScene = R"(
gravity: [0, 0, -9.80665]
time_step: 0.01
bodies:
)" + test::kLopsidedBox + R"(    twist: {frame: world, linear: [1, -2, 3], angular: [0.5, -1, 2]}
  - {name: other, shape: {box: [1, 2, 3]}, mass: 1,
     twist: {frame: world, linear: [0, 0, 0], angular: [0.1, 2, 0.1]}}
wrenches:
  - {body: other, frame: other, force: [1, 2, 3], start: 0.1234, duration: 3}
)";

Simulation simulationOf(const std::string& yaml) {
  const Scene scene = parseScene(yaml, "test");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

/// Every way to change a run, by the core alone; what the node says of it is noted beside.
class Recorded : public ::testing::Test {
 protected:
  void stepTo(std::int64_t step) {
    while (run.steps() < step) run.step();
  }

  void note(Input input) {
    input.number = inputs.size();
    input.step = static_cast<std::uint64_t>(run.steps());
    input.time = run.time();
    inputs.push_back(input);
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
    note(wrenchInput(slot, wrench, run.world()));
    run.applyWrench(slot, wrench);
  }

  void wholeRun() {
    push("", 0, 0, 0.20491);
    stepTo(5);
    push("a", 0, kWorld, std::numeric_limits<double>::infinity());
    push("b", 1, 0, 9);  // axes of another body: couples the two
    stepTo(17);
    note(clearInput("box", "a"));
    run.clearWrenches(0, "a");
    stepTo(21);
    SetState::Request request;
    request.body = request.frame = "box";
    request.pose.position = toPoint(Vector3d(1, 2, 3));
    request.pose.orientation = toQuaternion(Quaterniond(0.5, 0.5, 0.5, 0.5));
    request.twist.linear = toVector3(Vector3d(0.1, 0.2, 0.3));
    note(setStateInput(request));
    run.setState(0, takeState(request, run.world(), "world").state);
    stepTo(30);
    note(clearInput("", ""));
    run.clearWrenches();
    push("c", 0, kWorld, 1);
    stepTo(40);
    Input reset;
    reset.kind = Input::RESET;
    note(reset);
    run.reset(false);
    push("d", 0, 0, 9);
    push("e", 1, 1, 9);
    stepTo(45);
    note(clearInput("other", ""));
    run.clearWrenches(1);
    push("e", 1, 1, 9);
    stepTo(50);
    note(clearInput("", "e"));
    run.clearWrenches(0, "e");
    run.clearWrenches(1, "e");
  }

  void replayTo(std::int64_t step, InputReplay& replay, Simulation& repeated) const {
    while (repeated.steps() < step) {
      replay.applyDue(repeated);
      repeated.step();
    }
  }

  /// What the replay of the inputs says is wrong with them.
  std::string fault(const std::string& yaml = kScene) const {
    try {
      InputReplay replay(inputs, "world");
      Simulation repeated = simulationOf(yaml);
      replayTo(60, replay, repeated);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  Simulation run = simulationOf(kScene);
  std::vector<Input> inputs;
};

}  // namespace

TEST_F(Recorded, RunIsRepeatedToTheLastBit) {
  wholeRun();
  InputReplay replay(inputs, "world");
  Simulation repeated = simulationOf(kScene);
  for (std::int64_t step : {51, 60, 400}) {
    stepTo(step);
    replayTo(step, replay, repeated);
    for (std::size_t i : {0U, 1U}) {
      const BodyState& a = run.state().bodies[i];
      const BodyState& b = repeated.state().bodies[i];
      EXPECT_EQ(a.x_W, b.x_W);
      EXPECT_EQ(a.q_WP.coeffs(), b.q_WP.coeffs());
      EXPECT_EQ(a.p_W, b.p_W);
      EXPECT_EQ(a.L_W, b.L_W);
    }
  }
}

TEST_F(Recorded, EveryInputTellsInTheMotion) {
  wholeRun();
  stepTo(60);
  for (std::size_t left_out = 0; left_out < inputs.size(); ++left_out) {
    std::vector<Input> others = inputs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    for (std::size_t i = 0; i < others.size(); ++i) others[i].number = i;
    InputReplay replay(others, "world");
    Simulation repeated = simulationOf(kScene);
    replayTo(60, replay, repeated);
    const bool same = run.state().bodies[0].x_W == repeated.state().bodies[0].x_W &&
                      run.state().bodies[1].x_W == repeated.state().bodies[1].x_W;
    // input 7, the reset, wipes out what came before it
    const bool wiped = left_out < 7;
    EXPECT_EQ(same, wiped) << "input " << left_out;
  }
}

TEST_F(Recorded, OnlyTheLastRunCounts) {
  push("a", 0, 0, 9);
  for (Input& input : inputs) input.run = 0;
  std::vector<Input> earlier = inputs;
  inputs.clear();
  run = simulationOf(kScene);
  Input restart;
  restart.kind = Input::RESTART;
  note(restart);
  stepTo(3);
  push("b", 1, kWorld, 9);
  stepTo(60);
  for (Input& input : inputs) input.run = 1;
  inputs.insert(inputs.end(), earlier.begin(), earlier.end());  // a bag has them by time
  InputReplay replay(inputs, "world");
  Simulation repeated = simulationOf(kScene);
  replayTo(60, replay, repeated);
  EXPECT_EQ(run.state().bodies[0].x_W, repeated.state().bodies[0].x_W);
  EXPECT_EQ(run.state().bodies[1].x_W, repeated.state().bodies[1].x_W);
}

TEST_F(Recorded, RunThatLacksAnInputIsRefused) {
  wholeRun();
  inputs.erase(inputs.begin() + 2);
  EXPECT_NE(fault().find("input 2 of the run is missing"), std::string::npos) << fault();
  inputs.erase(inputs.begin(), inputs.begin() + 2);
  EXPECT_NE(fault().find("input 0 of the run is missing"), std::string::npos) << fault();
}

TEST_F(Recorded, RunOfAnotherSceneIsRefused) {
  wholeRun();
  std::string other_step = kScene;
  other_step.replace(other_step.find("0.01"), 4, "0.02");
  EXPECT_NE(fault(other_step).find("input 1: was taken over after step 5 at 0.05"),
            std::string::npos)
      << fault(other_step);
  std::string other_body = kScene;
  other_body.replace(other_body.find("name: box"), 9, "name: bxo");
  EXPECT_EQ(fault(other_body), "input 0: unknown body 'box'");
}

}  // namespace rigid_body_sim
