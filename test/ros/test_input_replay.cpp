#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "support/recorded_inputs.hpp"

namespace rigid_body_sim {

using test::Recorded;

TEST_F(Recorded, RunIsRepeatedToTheLastBit) {
  wholeRun();
  EXPECT_EQ(inputs.size(), 19U);
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
  Simulation repeated = test::simulationFrom(test::kRecordedScene);
  EXPECT_EQ(replay.lastStep(), 50U);
  EXPECT_EQ(replay.remaining(), inputs.size());
  replayTo(45, replay, repeated);
  EXPECT_EQ(replay.remaining(), 9U);
  replayTo(51, replay, repeated);
  EXPECT_TRUE(replay.isDone());
}

TEST_F(Recorded, EveryInputChangesTheMotion) {
  wholeRun();
  stepTo(60);
  // those of the guest, the last, make no sense one without the others
  for (std::size_t left_out = 0; left_out + 3 < inputs.size(); ++left_out) {
    std::vector<Input> others = inputs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    for (std::size_t i = 0; i < others.size(); ++i) others[i].number = i;
    InputReplay replay = replayOf(others);
    Simulation repeated = test::simulationFrom(test::kRecordedScene);
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
  Inputs watched_late(
      {[&] { return subscribers; },
       [&](const Input& message, const ros::Time&) { recorded.push_back(message); }},
      "world", run, origin, 0);
  watched_late.apply(ClearInput{});
  EXPECT_TRUE(recorded.empty());
  subscribers = 1;
  watched_late.apply(ClearInput{});
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

// taken while a step was under way, which has ended since
TEST_F(Recorded, WrenchThatComesLateIsRecordedAsItActs) {
  stepTo(7);
  PointWrench wrench = wrenchAtCenterOfMass(run.world().bodies, 0, {1, 2, 0.3}, {0, 0.1, 0});
  wrench.start = 0.0625;
  wrench.end = 0.09375;
  node.apply(WrenchInput{"a", wrench});
  ASSERT_EQ(inputs.size(), 1U);
  EXPECT_EQ(inputs[0].start, run.time());
  EXPECT_EQ(inputs[0].end, 0.09375 + (run.time() - 0.0625));
  expectRepeated(replayOf(inputs), 60);
  wrench.start = -std::numeric_limits<double>::infinity();
  EXPECT_THROW(node.apply(WrenchInput{"a", wrench}), std::invalid_argument);
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
  std::string other_step = test::kRecordedScene, other_body = test::kRecordedScene;
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
