#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/sweep/sweep_bench.hpp"

namespace rigid_body_sim {
namespace {

using test::numbersOf;
using test::sweep;

double shareBelow(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

double covarianceOf(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - mean_x) * (y[i] - mean_y);
  return sum / (n - 1);
}

}  // namespace

TEST(SweepOfAPush, GivesTheSpeedsOfANormalMass) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(time_step: 0.01
horizon: 2
bodies: [{name: ball, shape: {sphere: {radius: 0.1}}, mass: 2}]
wrenches: [{body: ball, frame: world, force: [3, 0, 0], start: 0.25, duration: 0.5}]
)");
  const std::string study = files.written(
      "study.yaml",
      "runs: 20000\nseed: 5\nvary: {bodies.ball.mass: {normal: {mean: 2, stddev: 0.2}}}");
  ASSERT_EQ(sweep(scene + " " + study + " --out " + files.path("out")).exit_code, 0);
  const auto table = test::tableAt(files.path("out/runs.csv"));
  std::vector<double> speed = numbersOf(table.at("ball.vx"));
  const std::vector<double> mass = numbersOf(table.at("bodies.ball.mass"));
  for (std::size_t i = 0; i < mass.size(); ++i) ASSERT_NEAR(speed[i], 1.5 / mass[i], 1e-15);
  // v = J/m < x where m > J/x
  std::sort(speed.begin(), speed.end());
  const auto n = static_cast<double>(speed.size());
  double greatest = 0;
  for (std::size_t i = 0; i < speed.size(); ++i)
    greatest = std::max(greatest, std::abs(shareBelow((2 - 1.5 / speed[i]) / 0.2) -
                                           (static_cast<double>(i) + 0.5) / n));
  EXPECT_LT(std::sqrt(n) * greatest, 1.95);
}

TEST(SweepOfAnOscillator, SpreadsAsItsCovarianceSays) {
  const TemporaryDirectory files;
  // along x, about the middle of two springs of equal ends: ω² = 2k/m = 4
  const std::string scene = files.written("scene.yaml", R"(time_step: 0.05
horizon: 2
tolerance: 1e-8
bodies: [{name: ball, shape: {sphere: {radius: 0.1}}, mass: 2, position: [0.3, 0, 0], twist: {frame: world, linear: [0.5, 0, 0]}}]
forces:
  - {type: spring, from: {body: ball}, to: {world: [-9, 0, 0]}, stiffness: 4, rest_length: 9}
  - {type: spring, from: {body: ball}, to: {world: [9, 0, 0]}, stiffness: 4, rest_length: 9}
)");
  const std::string study = files.written("study.yaml", R"(runs: 400
seed: 2
vary:
  bodies.ball.position[0]: {normal: {mean: 0.3, stddev: 0.1}}
  bodies.ball.twist.linear[0]: {normal: {mean: 0.5, stddev: 0.3}}
)");
  ASSERT_EQ(sweep(scene + " " + study + " --out " + files.path("out")).exit_code, 0);
  const auto table = test::tableAt(files.path("out/runs.csv"));
  const std::vector<double> x0 = numbersOf(table.at("bodies.ball.position[0]")),
                            v0 = numbersOf(table.at("bodies.ball.twist.linear[0]")),
                            x = numbersOf(table.at("ball.px")), v = numbersOf(table.at("ball.vx"));
  // the linear map, and what it makes of the covariance of what was drawn: Φ C Φᵀ
  const double w = 2, c = std::cos(w * 2), s = std::sin(w * 2);
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_NEAR(x[i], c * x0[i] + s / w * v0[i], 1e-6);
    ASSERT_NEAR(v[i], -w * s * x0[i] + c * v0[i], 1e-6);
  }
  const double xx = covarianceOf(x0, x0), xv = covarianceOf(x0, v0), vv = covarianceOf(v0, v0);
  EXPECT_NEAR(covarianceOf(x, x), c * c * xx + 2 * c * s / w * xv + s * s / (w * w) * vv, 1e-7);
  // and within chance that of the distribution itself
  const double sigma = c * c * 0.01 + s * s / (w * w) * 0.09;
  EXPECT_NEAR(covarianceOf(x, x), sigma, 3.5 * sigma * std::sqrt(2.0 / 400));
}

TEST(SweepRecords, LocateExtremesAndCrossingsWithinSteps) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(gravity: [0, 0, -10]
time_step: 0.07
horizon: 2
bodies: [{name: ball, shape: {sphere: {radius: 0.1}}, mass: 2, twist: {frame: world, linear: [0, 0, 5], angular: [0, 0, 2]}}]
)");
  const std::string study = files.written("study.yaml", R"(runs: 25
vary: {'bodies.ball.twist.linear[2]': {uniform: [3, 9]}}
record:
  apex: {max: ball.pz}
  lowest: {min: ball.pz}
  hits_ground: {first: {ball.pz: {below: 0}}}
  flies_high: {first: {ball.pz: {above: 2.45}}}
  never: {first: {ball.pz: {above: 1000}}}
  spin: {at_end: ball.w}
)");
  ASSERT_EQ(sweep(scene + " " + study + " --out " + files.path("out")).exit_code, 0);
  const auto table = test::tableAt(files.path("out/runs.csv"));
  const std::vector<double> v = numbersOf(table.at("bodies.ball.twist.linear[2]"));
  for (std::size_t i = 0; i < v.size(); ++i) {
    EXPECT_NEAR(std::stod(table.at("apex")[i]), v[i] * v[i] / 20, 1e-12);
    EXPECT_NEAR(std::stod(table.at("lowest")[i]), std::min(0.0, 2 * v[i] - 20), 1e-12);
    EXPECT_NEAR(std::stod(table.at("hits_ground")[i]), v[i] / 5, 1e-12);
    const double root = v[i] * v[i] - 20 * 2.45;
    EXPECT_EQ(table.at("flies_high")[i].empty(), root < 0);
    if (root > 0) {
      EXPECT_NEAR(std::stod(table.at("flies_high")[i]), (v[i] - std::sqrt(root)) / 10, 1e-12);
    }
    EXPECT_EQ(table.at("never")[i], "");
    EXPECT_NEAR(std::stod(table.at("spin")[i]), 2, 1e-15);
  }
}

TEST(SweepOfTolerances, EstimatesSmallerErrorsForTighterOnes) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(time_step: 0.02
horizon: 2
bodies: [{name: rod, shape: {box: [0.1, 0.2, 1]}, mass: 2, twist: {frame: world, angular: [1, 0.5, 0]}}]
forces: [{type: spring, from: {body: rod, point: [0, 0, 0.5]}, to: {world: [0, 1, 2]}, stiffness: 20, damping: 0.1}]
)");
  const std::string study = files.written("study.yaml", R"(runs: 2
vary:
  bodies.rod.mass: {uniform: [1, 2]}
  tolerance: {grid: [1e-3, 1e-9]}
)");
  ASSERT_EQ(sweep(scene + " " + study + " --out " + files.path("out")).exit_code, 0);
  const auto table = test::tableAt(files.path("out/runs.csv"));
  const std::vector<double> error = numbersOf(table.at("attitude_error"));
  ASSERT_EQ(error.size(), 4U);
  EXPECT_EQ(table.at("tolerance"), (std::vector<std::string>{"1e-3", "1e-9", "1e-3", "1e-9"}));
  for (std::size_t i = 0; i < 4; i += 2) EXPECT_LT(error[i + 1], 1e-2 * error[i]);
}

// their squares are beyond what a number holds, or below
TEST(SweepRecords, OfSpeedsAreRightAtAnySize) {
  const TemporaryDirectory files;
  for (const std::string size : {"e160", "e-170"}) {
    const std::string scene = files.written(
        "scene.yaml",
        "time_step: 0.01\nhorizon: 0.1\nbodies: [{name: ball, shape: {sphere: {radius: 1}}, mass: "
        "1, twist: {frame: world, linear: [3" +
            size + ", 4" + size + ", 0]}}]\n");
    const std::string study =
        files.written("study.yaml",
                      "runs: 1\nvary: {bodies.ball.mass: {uniform: [1, 2]}}\nrecord:\n  v: "
                      "{at_end: ball.v}\n  fast: {first: {ball.v: {above: 6" +
                          size + "}}}\n");
    // without gnuplot, which cannot draw such numbers
    const test::Outcome run =
        sweep(scene + " " + study + " --out " + files.path(size), "PATH=/nonexistent");
    ASSERT_EQ(run.exit_code, 0) << run.out;
    const auto table = test::tableAt(files.path(size + "/runs.csv"));
    const double speed = std::stod("5" + size);
    EXPECT_NEAR(std::stod(table.at("v")[0]) / speed, 1, 1e-15) << size;
    EXPECT_EQ(table.at("fast")[0], "") << size;
  }
}

TEST(SweepSummary, SaysWhatTheRowsSay) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml",
                    "runs: 501\nvary:\n  wrenches[0].force[0]: {uniform: [1, 3]}\n"
                    "  bodies.ball.twist.angular[2]: {uniform: [0, 1]}\n");
  const test::Outcome run = sweep(scene + " " + study + " --out " + files.path("out"));
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out.find("501 runs, 501 of them with a result\n"), 0U) << run.out;
  std::vector<double> x = numbersOf(test::tableAt(files.path("out/runs.csv")).at("ball.px"));
  std::sort(x.begin(), x.end());
  const auto summary = test::tableAt(files.path("out/summary.csv"));
  const auto& names = summary.at("column");
  const auto row =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), "ball.px") - names.begin());
  EXPECT_EQ(std::stod(summary.at("min")[row]), x.front());
  EXPECT_EQ(std::stod(summary.at("p50")[row]), x[250]);
  EXPECT_EQ(std::stod(summary.at("p25")[row]), x[125]);
  EXPECT_EQ(std::stod(summary.at("max")[row]), x.back());
  EXPECT_NEAR(std::stod(summary.at("stddev")[row]), std::sqrt(covarianceOf(x, x)), 1e-12);
  // the place follows the force, and not the spin
  EXPECT_NEAR(std::stod(summary.at("r:wrenches[0].force[0]")[row]), 1, 1e-12);
  EXPECT_LT(std::abs(std::stod(summary.at("r:bodies.ball.twist.angular[2]")[row])), 0.2);
  EXPECT_NE(run.out.find("+1.00 with wrenches[0].force[0]"), std::string::npos) << run.out;
}

TEST(SweepProgram, SaysThatThePlotIsMissingWithoutGnuplot) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: 3\nvary: {bodies.ball.mass: {uniform: [1, 2]}}");
  const test::Outcome run =
      sweep(scene + " " + study + " --out " + files.path("out"), "PATH=/nonexistent");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("gnuplot is not installed: "), std::string::npos) << run.out;
  EXPECT_FALSE(test::fileText(files.path("out/summary.csv")).empty());
}

}  // namespace rigid_body_sim
