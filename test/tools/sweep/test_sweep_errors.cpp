#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/sweep/sweep_bench.hpp"

/// What rows and the last lines say of errors.
namespace rigid_body_sim {
namespace {

/// A box that is thrown on a plane, which it has not touched yet: its motion is still solved.
const char* const kBouncingBox = R"(gravity: [0, 0, -9.80665]
time_step: 0.01
horizon: 3
tolerance: 1e-9
bodies:
  - {name: ground, shape: {plane: {}}, fixed: true}
  - name: box
    shape: {box: [0.4, 0.3, 0.2]}
    mass: 5.1
    position: [0, 0, 0.8]
    orientation: {rpy: [0.3, 0.5, 0.2]}
    twist: {frame: world, linear: [1.5, 0.2, 1], angular: [1, 4, 0.5]}
forces:
  - {type: contact, between: [box, ground], stiffness: 1e6, dissipation: 0, friction: 0.5}
)";

/// The number before " s on" in a text; none: not a number.
double lostAt(const std::string& text) {
  const std::size_t end = text.find(" s on, tolerance"), begin = text.rfind("from ", end) + 5;
  return end == std::string::npos ? std::nan("") : std::stod(text.substr(begin, end - begin));
}

}  // namespace

TEST(SweepErrors, SayWhereContactLosesTheTolerance) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", kBouncingBox);
  const std::string study =
      files.written("study.yaml", "runs: 1\nvary: {bodies.box.mass: {grid: [5]}}");
  const std::string out = files.path("out");
  const std::string command = scene + " " + study + " --out " + out;
  const test::Outcome run = test::sweep(command, "PATH=/nonexistent");
  ASSERT_EQ(run.exit_code, 0) << run.out;
  const auto table = test::tableAt(out + "/runs.csv");
  const std::vector<double> attitude = test::numbersOf(table.at("attitude_error")),
                            position = test::numbersOf(table.at("position_error"));
  EXPECT_EQ(table.at("status")[0], "done");
  EXPECT_GT(attitude[0], 1e-9);
  EXPECT_GT(position[0], 0);
  EXPECT_NE(run.out.find("1 run may have an error beyond the tolerance (runs.info says which); the "
                         "first is run 0: from "),
            std::string::npos)
      << run.out;
  // what `simulate` says of it
  ASSERT_EQ(test::sweep("--run 0 " + command).exit_code, 0);
  const test::Outcome alone =
      test::runCommand(RIGID_BODY_SIM_SIMULATE " " + out + "/run_0.yaml 2>&1");
  EXPECT_NEAR(lostAt(run.out), lostAt(alone.out), 1e-5) << run.out << alone.out;  // six digits
}

TEST(SweepErrors, StayEmptyWhereNothingCouldBeCompared) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kDoubtfulBall);
  const std::string study =
      files.written("study.yaml", "runs: 2\nvary: {bodies.ball.mass: {list: [1, 2]}}");
  const std::string out = files.path("out");
  const test::Outcome run = test::sweep(scene + " " + study + " --out " + out, "PATH=/nonexistent");
  ASSERT_EQ(run.exit_code, 0) << run.out;
  const auto table = test::tableAt(out + "/runs.csv");
  EXPECT_EQ(table.at("attitude_error"), (std::vector<std::string>{"", ""}));
  EXPECT_EQ(table.at("position_error"), (std::vector<std::string>{"", ""}));
  EXPECT_EQ(table.at("status"), (std::vector<std::string>{"done", "done"}));
  EXPECT_NE(run.out.find("2 runs may have errors beyond the tolerance (runs.info says which); the "
                         "first is run 0: "),
            std::string::npos)
      << run.out;
}

// Slack, it leaves its bodies to be solved; what follows is of an integrator.
TEST(SweepErrors, CountWhatATetherTightens) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(gravity: [0, 0, -9.80665]
time_step: 0.01
horizon: 4
tolerance: 1e-3
bodies:
  - name: box
    shape: {box: [0.1, 0.2, 0.3]}
    mass: 1
    position: [0.3, 0, 0.5]
    twist: {frame: world, linear: [1, 0.3, 0], angular: [3, -2, 1]}
forces:
  - type: tether
    from: {world: [0, 0, 1]}
    to: {body: box, point: [0.05, 0.1, 0.15]}
    stiffness: 500
    damping: 1
    length: 1
)");
  const std::string study =
      files.written("study.yaml", "runs: 2\nvary: {bodies.box.mass: {list: [1, 1.1]}}");
  const std::string out = files.path("out");
  const test::Outcome run = test::sweep(scene + " " + study + " --out " + out, "PATH=/nonexistent");
  ASSERT_EQ(run.exit_code, 0) << run.out;
  for (const double error : test::numbersOf(test::tableAt(out + "/runs.csv").at("attitude_error")))
    EXPECT_GT(error, 0);
  // auto has tried its steps beforehand, which the estimate does not belie
  EXPECT_EQ(run.out.find("beyond the tolerance"), std::string::npos) << run.out;
}

TEST(SweepErrors, AreNothingToSpeakOfWhereMotionIsSolved) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: 2\nvary: {bodies.ball.mass: {list: [1, 2]}}");
  const std::string out = files.path("out");
  const test::Outcome run = test::sweep(scene + " " + study + " --out " + out, "PATH=/nonexistent");
  ASSERT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.out.find("beyond the tolerance"), std::string::npos) << run.out;
  EXPECT_EQ(test::tableAt(out + "/runs.csv").at("attitude_error"),
            (std::vector<std::string>{"0", "0"}));
}

}  // namespace rigid_body_sim
