#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/node/status.hpp"

namespace rigid_body_sim {
namespace {

using diagnostic_msgs::DiagnosticStatus;

Simulation simulationOf(const std::string& yaml) {
  const Scene scene = parseScene(yaml, "test");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

const char* const kTwoBodies = R"(
gravity: [0, 0, -10]
time_step: 0.25
bodies:
  - {name: a, shape: {sphere: {radius: 1}}, mass: 2, position: [1, 0, 0], twist: {frame: world, linear: [0, 3, 0]}}
  - {name: b, shape: {sphere: {radius: 1}}, mass: 5, position: [0, 0, 4], twist: {frame: world, angular: [0, 0, 1]}}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 9, position: [0, 0, 7], fixed: true}
wrenches:
  - {body: a, frame: world, force: [1, 0, 0], start: 1, duration: 1}
)";

SimStatus statusOf(const Simulation& simulation) {
  SimStatus status;
  addFigures(simulation, status);
  return status;
}

diagnostic_updater::DiagnosticStatusWrapper described(const Health& health) {
  diagnostic_updater::DiagnosticStatusWrapper diagnostic;
  describe(health, diagnostic);
  return diagnostic;
}

}  // namespace

TEST(Status, ReportsTheMechanicsOfTheBodiesThatMove) {
  const SimStatus status = statusOf(simulationOf(kTwoBodies));
  const double spin = 0.4 * 5;  // 2/5 m r² ω
  // ½ 2 3², ½ L ω, and 5 kg 4 m up; the fixed body has no part in it
  EXPECT_NEAR(status.mechanical_energy, 9 + spin / 2 + 200, 1e-12);
  EXPECT_EQ(status.momentum.x, 0);
  EXPECT_NEAR(status.momentum.y, 6, 1e-14);
  EXPECT_EQ(status.momentum.z, 0);
  EXPECT_NEAR(status.angular_momentum.z, 6 + spin, 1e-13);  // 1 m beside the origin
}

TEST(Status, ReportsHowFarTheRunHasCome) {
  Simulation simulation = simulationOf(kTwoBodies);
  simulation.step();
  simulation.step();
  const SimStatus status = statusOf(simulation);
  EXPECT_EQ(status.time, 0.5);
  EXPECT_EQ(status.steps, 2U);
  EXPECT_EQ(status.active_wrenches, 1U);  // to come
  EXPECT_EQ(status.most_parts, 1U);
}

TEST(Status, EstimatesErrorsWithAutoOnly) {
  EXPECT_EQ(statusOf(simulationOf(kTwoBodies)).attitude_error, 0);
  const SimStatus named = statusOf(simulationOf("integrator: rk4\n" + std::string(kTwoBodies)));
  EXPECT_TRUE(std::isnan(named.attitude_error));
  EXPECT_TRUE(std::isnan(named.position_error));
}

TEST(Status, ReportsTheErrorThatAutoLeaves) {
  Simulation simulation = simulationOf(R"(
time_step: 0.01
tolerance: 1.0e-3
bodies:
  - {name: a, shape: {box: [1, 2, 3]}, mass: 1, position: [0, 0, -2], twist: {frame: world, linear: [1, 0, 0]}}
forces:
  - {type: spring, from: {body: a, point: [0.5, 0, 0]}, to: {world: [0, 0, 0]}, stiffness: 10, damping: 0, rest_length: 1}
)");
  simulation.trackError();
  for (int i = 0; i < 100; ++i) simulation.step();
  const SimStatus status = statusOf(simulation);
  EXPECT_GT(status.attitude_error, 0);
  EXPECT_GT(status.position_error, 0);
  EXPECT_LT(status.attitude_error, 1e-3);  // the tolerance
  EXPECT_TRUE(holdsTolerance(simulation));
}

TEST(Status, ReportsTheBalanceWhereItIsTracked) {
  Simulation simulation = simulationOf(kTwoBodies);
  const SimStatus before = statusOf(simulation);
  EXPECT_TRUE(std::isnan(before.work));
  EXPECT_TRUE(std::isnan(before.energy_balance));
  EXPECT_TRUE(std::isnan(before.momentum_balance.x));
  EXPECT_TRUE(std::isnan(before.angular_momentum_balance.z));
  simulation.trackBalance();
  for (int i = 0; i < 8; ++i) simulation.step();
  const SimStatus status = statusOf(simulation);
  EXPECT_NEAR(status.work, 0.25, 1e-14);             // 1 N along ½ 1 N/2 kg (1 s)²
  EXPECT_NEAR(status.energy_balance, 0, 1e-12);      // of 209 J
  EXPECT_NEAR(status.momentum_balance.z, 0, 1e-12);  // of 140 N s
  EXPECT_NEAR(status.angular_momentum_balance.y, 0, 1e-12);
}

TEST(Status, CountsThePartsOfSteps) {
  // 50 rad a step, where strang follows 0.8
  Simulation simulation = simulationOf(R"(
time_step: 1
integrator: strang
bodies: [{name: a, shape: {box: [1, 2, 3]}, mass: 1, twist: {frame: world, angular: [50, 1, 0]}}]
)");
  simulation.step();
  EXPECT_GT(statusOf(simulation).most_parts, 50U);
}

TEST(Diagnostics, AreWellUnlessSomethingIsNot) {
  Health health;
  health.status.most_parts = 1;
  health.status.overruns = 7;  // of long ago
  EXPECT_EQ(described(health).level, DiagnosticStatus::OK);
  EXPECT_EQ(described(health).message, "running");
  health.status.paused = true;
  EXPECT_EQ(described(health).message, "paused");
}

TEST(Diagnostics, WarnOfWhatCostsAccuracyOrTime) {
  Health health;
  health.status.most_parts = 12;
  EXPECT_EQ(described(health).level, DiagnosticStatus::WARN);
  EXPECT_EQ(described(health).message, "steps are taken in up to 12 substeps");
  health.new_overruns = 3;
  health.holds_tolerance = false;
  const std::string all = described(health).message;
  EXPECT_NE(all.find("3 steps began late"), std::string::npos);
  EXPECT_NE(all.find("up to 12 substeps"), std::string::npos);
  EXPECT_NE(all.find("the scene's tolerance is not held"), std::string::npos);
}

TEST(Diagnostics, WarnOfWhatIsBeyondNumbers) {
  Simulation simulation = simulationOf(R"(
time_step: 1
bodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 2, twist: {frame: world, linear: [0, 1e155, 0]}}]
)");
  Health health;
  health.status = statusOf(simulation);
  EXPECT_EQ(described(health).level, DiagnosticStatus::WARN);
  EXPECT_EQ(described(health).message,
            "energy or momentum is beyond 1.8e308, and their balances are not known");
  health.status.mechanical_energy = 0;
  EXPECT_EQ(described(health).level, DiagnosticStatus::OK);
  health.status.angular_momentum.z = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(described(health).level, DiagnosticStatus::WARN);
}

TEST(Diagnostics, HoldAnEstimatedErrorAgainstTheToleranceUpToTheHorizon) {
  SolverOptions solver;
  solver.tolerance = 1e-6;
  solver.horizon = 5;
  EXPECT_TRUE(isWithinTolerance({1e-6, 1}, 5, solver));
  EXPECT_FALSE(isWithinTolerance({1.1e-6, 0}, 5, solver));
  EXPECT_TRUE(isWithinTolerance({1.1e-6, 0}, 5.001, solver));
  solver.integrator = "rk4";
  EXPECT_TRUE(isWithinTolerance({1, 0}, 1, solver));
}

TEST(Diagnostics, TellTheSizesOfTheBalances) {
  Health health;
  health.status.energy_balance = -0.5;
  health.status.momentum_balance.x = 3;
  health.status.momentum_balance.y = 4;
  const auto value = [&](const std::string& key) {
    for (const auto& entry : described(health).values)
      if (entry.key == key) return std::stod(entry.value);
    return std::nan("");
  };
  EXPECT_EQ(value("energy balance [J]"), -0.5);
  EXPECT_EQ(value("momentum balance [kg m/s]"), 5);
  EXPECT_EQ(value("angular momentum balance [kg m^2/s]"), 0);
}

TEST(Diagnostics, NameADivergenceAsAnError) {
  Health health;
  health.new_overruns = 3;
  health.divergence = "t = 1 s: body 'a': momentum is no longer finite";
  EXPECT_EQ(described(health).level, DiagnosticStatus::ERROR);
  EXPECT_EQ(described(health).message, "diverged: " + health.divergence);
}

}  // namespace rigid_body_sim
