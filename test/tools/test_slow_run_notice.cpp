#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "tools/common/slow_run_notice.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kNever = 1e9, kAtOnce = 0;  // [s] of patience

Simulation simulationOfScene(const std::string& yaml) {
  const Scene scene = parseScene(yaml, "slow");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

/// A symmetric body that a steady torque makes turn faster and faster, and that nutates, so that no
/// closed form is known; beside a slow one.
const char* const kSpinUp = R"(
time_step: 10
bodies:
  - {name: slow, shape: {sphere: {radius: 1}}, mass: 1, position: [9, 0, 0]}
  - {name: wheel, shape: {cylinder: {radius: 1, length: 0.1}}, mass: 1,
     twist: {frame: wheel, angular: [0.1, 0, 0]}}
wrenches: [{body: wheel, frame: wheel, torque: [0, 0, 1], duration: 1000}]
)";

/// What is said of a run of 10 s after its first step.
std::string saidAtOnce(const std::string& yaml) {
  Simulation simulation = simulationOfScene(yaml);
  SlowRunNotice notice(10, kAtOnce);
  simulation.step();
  return notice.textIfDue(simulation);
}

}  // namespace

TEST(SlowRunNotice, NamesTheBodyThatTurnsFastestAndHowFast) {
  Simulation simulation = simulationOfScene(kSpinUp);
  SlowRunNotice notice(1e4, kAtOnce);
  simulation.step();
  const std::string text = notice.textIfDue(simulation);
  EXPECT_NE(text.find("the run has come to 10 of 1e+04 s"), std::string::npos) << text;
  // ω = τ t / I with I = m r²/2
  EXPECT_NE(text.find("solved radian by radian ('wheel' turns fastest, at 20 rad/s)"),
            std::string::npos)
      << text;
}

TEST(SlowRunNotice, NamesSubstepsAndShortSteps) {
  const std::string body =
      "bodies: [{name: wheel, shape: {sphere: {radius: 1}}, mass: 1, twist: "
      "{frame: world, angular: [0, 0, 100]}}]\n";
  SlowRunNotice divided(10, kAtOnce), many(10, kAtOnce);
  Simulation fast = simulationOfScene("time_step: 1\nintegrator: rk4\n" + body);
  fast.step();
  ASSERT_GT(fast.maxSubsteps(), 1);
  const std::string text = divided.textIfDue(fast);
  EXPECT_NE(text.find("divided into up to " + std::to_string(fast.maxSubsteps()) + " substeps"),
            std::string::npos)
      << text;
  Simulation fine = simulationOfScene("time_step: 1.0e-6\n" + body);
  fine.step();
  EXPECT_NE(many.textIfDue(fine).find("it takes many steps of 1e-06 s"), std::string::npos);
  SlowRunNotice few(10, kAtOnce);
  Simulation coarse = simulationOfScene(
      "time_step: 3\nbodies: [{name: ball, shape: {sphere: {radius: 1}}, mass: 1}]\n");
  coarse.step();
  EXPECT_NE(
      few.textIfDue(coarse).find("each of its steps of 3 s takes long, or the processor is busy"),
      std::string::npos);
}

TEST(SlowRunNotice, NamesTheBodyThatDragSlowsDownFastest) {
  const std::string text = saidAtOnce(R"(
time_step: 1
gravity: [0, 0, -9.81]
bodies:
  - {name: ball, shape: {sphere: {radius: 1}}, mass: 2, drag: {quadratic: 0.1}}
  - {name: leaf, shape: {sphere: {radius: 1}}, mass: 2, drag: {linear: [100, 100, 100]},
     twist: {frame: world, angular: [0, 0, 1]}, position: [5, 0, 0]}
)");
  EXPECT_NE(text.find("as short as drag is strong (it slows 'leaf' down at 50/s)"),
            std::string::npos)
      << text;
}

TEST(SlowRunNotice, NamesWhatALawMakesSwingOrSlowDownFastest) {
  const std::string text = saidAtOnce(R"(
time_step: 0.01
integrator: rk4
bodies: [{name: a, shape: {sphere: {radius: 0.1}}, mass: 2}]
forces: [{type: spring, from: {world: [0, 0, 1]}, to: {body: a}, stiffness: 1, damping: 2000}]
)");
  EXPECT_NE(text.find("(fastest is what spring makes 'a' swing or slow down by, at 1e+03/s)"),
            std::string::npos)
      << text;
}

// Or a watch over single steps takes many of them for one.
TEST(SlowRunNotice, LooksOnOnceItIsSaid) {
  Simulation simulation = simulationOfScene(kSpinUp);
  SlowRunNotice notice(1e4, kAtOnce);
  simulation.step();
  EXPECT_NE(notice.textIfDue(simulation), "");
  constexpr int kMostAtOnce = 10;  // times as many as up to the look before
  EXPECT_LE(notice.nextLook(), simulation.steps() + kMostAtOnce);
  EXPECT_GT(notice.nextLook(), simulation.steps());
}

TEST(SlowRunNotice, ComesOnceAndNotBeforeItsTime) {
  Simulation simulation = simulationOfScene(kSpinUp);
  SlowRunNotice late(1e4, kNever), early(1e4, kAtOnce);
  int count = 0;
  for (int i = 0; i < 10; ++i) {
    simulation.step();
    EXPECT_EQ(late.textIfDue(simulation), "");
    if (!early.textIfDue(simulation).empty()) ++count;
  }
  EXPECT_EQ(count, 1);
}

}  // namespace rigid_body_sim
