#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"
#include "tools/plot/attitude_angles.hpp"
#include "tools/plot/figures.hpp"

namespace rigid_body_sim {
namespace {

Quaterniond turned(double angle, const Vector3d& axis) {
  return Quaterniond(Eigen::AngleAxisd(angle, axis));
}

/// The figures of a scene that is simulated and read again.
std::vector<Figure> figuresOfScene(const std::string& yaml, const std::string& options,
                                   const std::string& body) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", yaml), out = files.path("out");
  const std::string command =
      RIGID_BODY_SIM_SIMULATE " " + scene + " " + options + " --plot " + out;
  EXPECT_EQ(test::runCommand("PATH=/nonexistent " + command + " 2>&1").exit_code, 0);
  const RunData run = readRun({out + "/motion.csv", out + "/forces.csv", out + "/balance.csv"});
  return figuresOf(run, {body});
}

const Figure* figureNamed(const std::string& name, const std::vector<Figure>& figures) {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const Figure& figure) { return figure.name == name; });
  return found == figures.end() ? nullptr : &*found;
}

/// The last value of the first curve of each panel.
std::vector<double> lastOf(const Figure* figure) {
  std::vector<double> values;
  if (!figure) return values;
  for (const Panel& panel : figure->panels) values.push_back(panel.curves.at(0).y.back());
  return values;
}

}  // namespace

// As of a node: a reset begins a balance anew.
TEST(BalanceFigures, FollowAReset) {
  RunData run;
  constexpr std::size_t kEnergy = 0, kWork = 2, kLeft = 9;
  for (const double work : {0., 1., 2., 0., 5.}) {
    const bool is_reset = run.balance.t.size() >= 3;
    std::array<double, 16> row{};
    row[kWork] = work;
    row[kLeft] = 0.125;
    row[kEnergy] = (is_reset ? 100 : 10) + work + row[kLeft];
    run.balance.t.push_back(static_cast<double>(run.balance.t.size()));
    run.balance.rows.push_back(row);
  }
  const std::vector<Figure> figures = balanceFigures(run);
  const Figure* energy = figureNamed("energy", figures);
  ASSERT_NE(energy, nullptr);
  EXPECT_EQ(energy->panels.at(0).curves.at(1).y, (std::vector<double>{10, 11, 12, 100, 105}));
}

TEST(AttitudeAngles, GoOnBeyondATurnAboutEachAxis) {
  for (const int axis : {0, 1, 2}) {
    AttitudeAngles angles;
    const double step = 0.1;
    for (int k = 0; k <= 200; ++k) {
      Vector3d expected = Vector3d::Zero();
      expected[axis] = k * step;
      // the other sign is the same attitude
      Quaterniond q = turned(k * step, Vector3d::Unit(axis));
      if (k % 3 == 0) q.coeffs() *= -1;
      EXPECT_LT((angles.next(q) - expected).norm(), 1e-6) << axis << ' ' << k;
    }
  }
}

TEST(AttitudeAngles, MeanTheAttitude) {
  AttitudeAngles angles;
  const Vector3d axis = Vector3d(1, 2, -0.5).normalized();
  Vector3d last = angles.next(Quaterniond::Identity());
  for (int k = 1; k < 500; ++k) {
    const Quaterniond q = turned(0.02 * k, axis) * turned(0.05 * k, Vector3d::UnitX());
    const Vector3d a = angles.next(q);
    const Quaterniond back = turned(a.z(), Vector3d::UnitZ()) * turned(a.y(), Vector3d::UnitY()) *
                             turned(a.x(), Vector3d::UnitX());
    EXPECT_LT(back.angularDistance(q), 1e-7);
    EXPECT_LT((a - last).norm(), 1) << k;
    last = a;
  }
}

// Turning about x by 0.3 rad a sample: ten whole turns, then it is away, or put back.
TEST(PlotFigures, ShowAttitudeAnewAfterAnAbsenceAndAfterAReset) {
  constexpr int kCount = 210, kLater = 3;  // up to half a turn
  const double wx = 3, dt = 0.1;
  for (const double pause : {0., dt, 5.}) {  // [s] set while time stood, in the run, and away
    RunData run;
    Samples<13>& box = run.motion.of("box");
    const auto add = [&](double t, double angle) {
      box.t.push_back(t);
      box.rows.push_back(
          {0, 0, 0, std::sin(angle / 2), 0, 0, std::cos(angle / 2), 0, 0, 0, wx, 0, 0});
    };
    for (int k = 0; k < kCount; ++k) add(k * dt, k * wx * dt);
    for (int k = 0; k < kLater; ++k) add((kCount - 1 + k) * dt + pause, 2 + k * wx * dt);
    const std::vector<Figure> figures = figuresOf(run, {"box"});
    const Figure* attitude = figureNamed("attitude", figures);
    ASSERT_NE(attitude, nullptr);
    const std::vector<double>& roll = attitude->panels[0].curves[0].y;
    const double degrees = 180 / std::acos(-1.0);
    for (int k = 0; k < kCount; ++k)
      EXPECT_NEAR(roll[static_cast<std::size_t>(k)], degrees * k * wx * dt, 1e-6) << k;
    for (int k = 0; k < kLater; ++k)
      EXPECT_NEAR(roll[static_cast<std::size_t>(kCount + k)], degrees * (2 + k * wx * dt), 1e-6)
          << pause << ' ' << k;
  }
}

TEST(PlotFigures, ShowRatesInTheAxesOfTheBody) {
  RunData run;
  const double s = std::sqrt(0.5);
  // a quarter of a turn about z: the body's x axis is the world's y axis
  run.motion.of("box").t = {0};
  run.motion.of("box").rows = {{1, 2, 3, 0, 0, s, s, 4, 5, 6, 0, 7, 0}};
  const std::vector<Figure> figures = figuresOf(run, {"box"});
  const std::vector<double> rates = lastOf(figureNamed("rates", figures));
  EXPECT_NEAR(rates.at(0), 7, 1e-12);
  EXPECT_NEAR(rates.at(1), 0, 1e-12);
  EXPECT_EQ(lastOf(figureNamed("position", figures)), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(lastOf(figureNamed("velocity", figures)), (std::vector<double>{4, 5, 6}));
  EXPECT_NEAR(lastOf(figureNamed("attitude", figures)).at(2), 90, 1e-9);
  EXPECT_EQ(figureNamed("force", figures), nullptr);
}

TEST(PlotFigures, DrawRoundingAsAStraightLine) {
  RunData run;
  Samples<13>& hovers = run.motion.of("drone");
  hovers.t = {0, 1};
  hovers.rows = {{1.5, 0, 1, 0, 0, 0, 1}, {1.5, 0, 1 + 1e-15, 0, 0, 0, 1}};
  EXPECT_EQ(figureNamed("position", figuresOf(run, {"drone"}))->panels[2].scale, 1.5);
  hovers.rows[1][2] = 1.001;
  EXPECT_NEAR(figureNamed("position", figuresOf(run, {"drone"}))->panels[2].scale, 0.001, 1e-12);
}

TEST(PlotFigures, ShowTheForceAndTorqueOfAWrench) {
  const std::vector<Figure> figures = figuresOfScene(R"(
gravity: [0, 0, -9.80665]
time_step: 0.01
bodies: [{name: box, shape: {sphere: {radius: 0.5}}, mass: 2}]
wrenches: [{body: box, point: [0, 0.5, 0], frame: world, force: [3, 0, 1], duration: 9}]
)",
                                                     "--duration 0.01", "box");
  const std::vector<double> force = lastOf(figureNamed("force", figures));
  ASSERT_EQ(force.size(), 3U);
  EXPECT_NEAR(force[0], 3, 1e-12);
  EXPECT_NEAR(force[1], 0, 1e-12);
  EXPECT_NEAR(force[2], 1, 1e-12);
  // r × f at the start, where the sphere has not turned
  const Figure* torque = figureNamed("torque", figures);
  ASSERT_NE(torque, nullptr);
  EXPECT_NEAR(torque->panels[0].curves[0].y[0], 0.5, 1e-12);
  EXPECT_NEAR(torque->panels[2].curves[0].y[0], -1.5, 1e-12);
}

TEST(PlotFigures, ShowTheWeightThatAPivotCarries) {
  const std::vector<Figure> figures = figuresOfScene(R"(
gravity: [0, 0, -10]
time_step: 0.01
bodies:
  - {name: bob, mass: 2, inertia: {ixx: 1, iyy: 1, izz: 1}, center_of_mass: [0, 0, -1],
     pivot: {point: [0, 0, 0]}}
)",
                                                     "--duration 0.1", "bob");
  EXPECT_NEAR(lastOf(figureNamed("force", figures)).at(2), 20, 1e-9);
  EXPECT_EQ(figureNamed("torque", figures), nullptr);
}

TEST(PlotFigures, ShowNoForceOnABodyThatFallsFreely) {
  const std::vector<Figure> figures = figuresOfScene(R"(
gravity: [0, 0, -10]
time_step: 0.01
bodies:
  - {name: box, shape: {box: [1, 2, 3]}, mass: 2, twist: {frame: body, angular: [1, 2, 3]}}
)",
                                                     "--duration 1", "box");
  EXPECT_EQ(figureNamed("force", figures), nullptr);
  EXPECT_EQ(figureNamed("torque", figures), nullptr);
  // in the balance: 2 kg fall from rest for 1 s
  EXPECT_NEAR(lastOf(figureNamed("momentum", figures)).at(0), 0, 1e-12);
  EXPECT_NEAR(figureNamed("momentum", figures)->panels[0].curves[2].y.back(), -20, 1e-9);
  const Figure* balance = figureNamed("balance", figures);
  ASSERT_NE(balance, nullptr);
  EXPECT_NE(balance->panels[0].title.find("of the greatest kinetic energy"), std::string::npos)
      << balance->panels[0].title;
  for (const Panel& panel : balance->panels)
    for (const double y : panel.curves[0].y) EXPECT_LT(std::abs(y), 1e-12);
}

TEST(PlotFigures, ShowTheWorkOfAWrenchInTheEnergy) {
  const std::vector<Figure> figures = figuresOfScene(R"(
time_step: 0.01
bodies: [{name: box, shape: {sphere: {radius: 0.5}}, mass: 2}]
wrenches: [{body: box, frame: world, force: [4, 0, 0], duration: 9}]
)",
                                                     "--duration 1", "box");
  const Figure* energy = figureNamed("energy", figures);
  ASSERT_NE(energy, nullptr);
  // F²t²/2m, as energy, as work done, as kinetic energy
  ASSERT_EQ(energy->panels[0].curves.size(), 3U);
  for (const Curve& curve : energy->panels[0].curves) EXPECT_NEAR(curve.y.back(), 4, 1e-9);
}

}  // namespace rigid_body_sim
