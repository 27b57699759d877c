#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"

/// simulate --save and --load.
namespace rigid_body_sim {
namespace {

// in contact, with a motor that lags, a wrench that acts and one to come
const char* const kCutScene = R"(
time_step: 0.005
gravity: [0, 0, -9.81]
tolerance: 1.0e-4
bodies:
  - {name: ground, shape: {plane: {}}, fixed: true}
  - name: crate
    shape: {box: [0.4, 0.3, 0.2]}
    mass: 5
    position: [0, 0, 0.15]
    twist: {frame: world, linear: [1, 0, 0], angular: [0, 0, 3]}
    thrusters: {jet: {direction: [0, 1, 0.2], limits: [0, 20], time_constant: 0.1}}
  - {name: top, shape: {box: [1, 2, 3]}, mass: 1, position: [0, 0, 9], twist: {frame: world, angular: [0.1, 4, 0.2]}}
forces:
  - {type: contact, between: [ground, crate], stiffness: 1.0e+4, dissipation: 1, friction: 0.3}
wrenches:
  - {body: top, frame: top, torque: [0.1, 0, 0], start: 0.0777, duration: 0.2}
  - {body: crate, frame: world, force: [2, 1, 0], start: 0.3333, duration: 1}
commands:
  - {body: crate, actuator: jet, value: 9, start: 0.1111}
  - {body: crate, actuator: jet, value: 2, start: 0.4444}
)";

class SimulateStates : public ::testing::Test {
 protected:
  test::Outcome simulate(const std::string& arguments) const {
    return test::runCommand(std::string(RIGID_BODY_SIM_SIMULATE) + " " + scene + " " + arguments +
                            " 2>&1");
  }

  std::string content(const std::string& name) const {
    std::ifstream file(directory.path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  /// The rows of the last two bodies, those that move, at the last sample.
  static std::string lastRows(const std::string& csv) {
    std::size_t at = csv.size() - 1;
    for (int rows = 0; rows < 2; ++rows) at = csv.rfind('\n', at - 1);
    return csv.substr(at + 1);
  }

  TemporaryDirectory directory;
  std::string scene = directory.written("scene.yaml", kCutScene);
};

}  // namespace

TEST_F(SimulateStates, CutAtAnyStepEndWithTheBitsOfTheRunInOne) {
  const std::string csv = " --csv " + directory.path("end.csv");
  ASSERT_EQ(simulate("--duration 0.6 --save " + directory.path("whole") + csv).exit_code, 0);
  const std::string end = lastRows(content("end.csv"));
  const std::string whole = content("whole");
  std::mt19937 random(1);
  for (int k = 0; k < 8; ++k) {
    const int steps = 1 + static_cast<int>(random() % 118);
    const std::string first = "--duration " + std::to_string(0.005 * steps) + " --save ";
    ASSERT_EQ(simulate(first + directory.path("cut")).exit_code, 0);
    const test::Outcome rest =
        simulate("--load " + directory.path("cut") + " --duration " +
                 std::to_string(0.005 * (120 - steps)) + " --save " + directory.path("rest") + csv);
    ASSERT_EQ(rest.exit_code, 0) << rest.out;
    EXPECT_EQ(lastRows(content("end.csv")), end) << steps;
    EXPECT_EQ(content("rest"), whole) << steps;
  }
}

TEST_F(SimulateStates, GoOnWithAnotherNumberOfThreads) {
  ASSERT_EQ(simulate("--duration 0.1 --save " + directory.path("cut")).exit_code, 0);
  scene = directory.written("threads.yaml", std::string("threads: 3") + kCutScene);
  const test::Outcome rest = simulate("--load " + directory.path("cut") + " --duration 0.1");
  EXPECT_EQ(rest.exit_code, 0) << rest.out;
  EXPECT_EQ(simulate("--threads 0").out.substr(0, 48),
            "simulate: --threads: must be a whole number from");
}

TEST_F(SimulateStates, GoOnAtTheTimesOfTheRunInOne) {
  const std::string sampled = " --sample 0.05 --csv ";
  ASSERT_EQ(simulate("--duration 0.32" + sampled + directory.path("whole.csv")).exit_code, 0);
  ASSERT_EQ(simulate("--duration 0.12 --save " + directory.path("cut")).exit_code, 0);
  const test::Outcome rest = simulate("--load " + directory.path("cut") + " --duration 0.2" +
                                      sampled + directory.path("rest.csv"));
  EXPECT_NE(rest.out.find(": 0.2 s on from 0.12 s in steps of"), std::string::npos) << rest.out;
  // a row at once, then those of the run in one
  const std::string rows = content("rest.csv"), whole = content("whole.csv");
  EXPECT_EQ(rows.find("\n0.12,ground,"), rows.find('\n'));
  const std::string from = "\n0.14999999999999999,ground,";
  ASSERT_NE(whole.find(from), std::string::npos) << whole;
  ASSERT_NE(rows.find(from), std::string::npos) << rows;
  EXPECT_EQ(rows.substr(rows.find(from)), whole.substr(whole.find(from)));
}

// as a node saves it, whose wrenches are no part of the scene
TEST_F(SimulateStates, SayThatWrenchesActWhichTheSceneDoesNotHave) {
  scene = directory.written(
      "bare.yaml",
      "time_step: 0.01\nbodies: [{name: box, shape: {sphere: {radius: 1}}, mass: 2}]\n");
  const Scene bare = loadScene(scene);
  const World world = buildWorld(bare);
  Simulation node(world, initialState(bare, world));
  PointWrench push;
  push.force = {1, 0, 0};
  node.applyWrench("topic", push);
  saveState(directory.path("cut"), world, node.state());
  const test::Outcome rest = simulate("--load " + directory.path("cut") + " --duration 1");
  ASSERT_EQ(rest.exit_code, 0) << rest.out;
  EXPECT_NE(rest.out.find("box: wrenches, "), std::string::npos) << rest.out;
  EXPECT_NE(rest.out.find("changed by wrenches: energy "), std::string::npos) << rest.out;
}

TEST_F(SimulateStates, AreRefusedInOneLine) {
  ASSERT_EQ(simulate("--duration 0.1 --save " + directory.path("cut")).exit_code, 0);
  const std::string load = "--load " + directory.path("cut");
  const auto refusal = [&](const std::string& arguments, int exit_code) {
    const test::Outcome run = simulate(arguments);
    EXPECT_EQ(run.exit_code, exit_code) << run.out;
    EXPECT_EQ(run.out.find('\n'), run.out.size() - 1) << run.out;
    return run.out;
  };
  EXPECT_NE(refusal(load + " --time-step 0.001", 1).find(":4: solver.time_step must be 0.001"),
            std::string::npos);
  EXPECT_NE(refusal("--load " + scene, 1).find("is no saved state"), std::string::npos);
  EXPECT_NE(refusal("--load " + directory.path("none"), 1).find("cannot be opened"),
            std::string::npos);
  EXPECT_NE(refusal("--duration 0.1012 --save " + directory.path("x"), 2)
                .find("--save needs an end at a step"),
            std::string::npos);
  EXPECT_NE(refusal("--duration 1e-13", 2)
                .find("--duration must be at least a billionth of the time step 0.005 s"),
            std::string::npos);
  EXPECT_NE(refusal("--duration 0.1 --save " + directory.path("none/x"), 1)
                .find("cannot be written: No such file or directory"),
            std::string::npos);
  EXPECT_NE(refusal(load + " --save " + directory.path("cut"), 2).find("--save"),
            std::string::npos);
  EXPECT_NE(refusal(load + " --wrench-bag x.bag", 2).find("exclude each other"), std::string::npos);
}

}  // namespace rigid_body_sim
