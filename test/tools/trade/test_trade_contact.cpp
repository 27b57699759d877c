#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"
#include "tools/trade/trade_contact.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kWeight = 9.81;    // [N] of 1 kg
constexpr double kStiffness = 1e4;  // [N/m]
constexpr double kDrop = 0.5;       // [m]
constexpr double kRadius = 0.1;     // [m]
constexpr double kSeconds = 3;      // [s]
constexpr double kBudget = 1e-6;    // [relative]
constexpr Patience kBrief{0, 0};

const char* const kElasticBall = R"(
gravity: [0, 0, -9.81]
time_step: 0.01
horizon: 3
bodies:
  - {name: ground, shape: {plane: {}}, fixed: true}
  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 1, position: [0, 0, 0.6]}
forces:
  - {type: contact, between: [ball, ground], stiffness: 1.0e+4, exponent: 1, dissipation: 0}
)";

/// [m] Height of the lowest point of a ball that bounces for ever on a linear spring: a parabola,
/// and the harmonic swing  δ = g/ω² (1 − cos ωτ) + v/ω sin ωτ  while it touches.
double bouncingHeight(double t) {
  const double omega = std::sqrt(kStiffness), fall = std::sqrt(2 * kDrop / kWeight);
  const double v = kWeight * fall, a = kWeight / (omega * omega), b = v / omega;
  const double touching = 2 * (M_PI - std::atan2(b, a)) / omega;
  const double since = std::fmod(t + fall, touching + 2 * fall);  // since the last release
  if (since < 2 * fall) return v * since - kWeight * since * since / 2;
  const double swing = omega * (since - 2 * fall);
  return -(a * (1 - std::cos(swing)) + b * std::sin(swing));
}

struct ContactBench {
  explicit ContactBench(const std::string& yaml) : scene(parseScene(yaml, "test")) {}
  Scene scene;
  World world = buildWorld(scene);
  State initial = initialState(scene, world);
};

std::vector<Setting> settingsOf(const ContactBench& bench, const Reference& reference) {
  std::vector<Setting> settings;
  climbTolerances(
      bench.world, reference, "auto", [&](const Setting& s) { settings.push_back(s); }, kBrief);
  return settings;
}

}  // namespace

TEST(TradeContact, ReportsErrorsThatAreTrueWithinAFactorOfTwo) {
  const ContactBench bench(kElasticBall);
  const Reference reference = contactReference(bench.world, bench.initial, kSeconds, kBudget);
  EXPECT_GT(reference.known_until, 0.999 * kSeconds);
  Reference truth = reference;
  for (State& state : truth.states) {
    state.bodies[1].x_W[2] = bouncingHeight(state.t) + kRadius;
    state.bodies[1].x_low_W.setZero();
  }
  const std::vector<Setting> reported = settingsOf(bench, reference),
                             real = settingsOf(bench, truth);
  ASSERT_EQ(reported.size(), real.size());
  ASSERT_GT(reported.size(), 8U);
  int told_apart = 0;
  for (std::size_t i = 0; i < real.size(); ++i) {
    const double error = real[i].errors.position;
    if (error < 10 * std::max(reference.doubt.position, 1e-12)) continue;
    EXPECT_LT(reported[i].errors.position, 2 * error) << real[i].tolerance;
    EXPECT_GT(reported[i].errors.position, error / 2) << real[i].tolerance;
    EXPECT_LT(error, real[i].tolerance);
    ++told_apart;
  }
  EXPECT_GT(told_apart, 2);
}

TEST(TradeContact, SaysUntilWhenAMotionIsKnown) {
  // a ball that hops to and fro in the valley between two others: each hop magnifies deviations
  const ContactBench bench(R"(
gravity: [0, 0, -9.81]
time_step: 0.01
bodies:
  - {name: left, mass: 1, shape: {sphere: {radius: 1}}, fixed: true, position: [-1, 0, 0]}
  - {name: right, mass: 1, shape: {sphere: {radius: 1}}, fixed: true, position: [1, 0, 0]}
  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 1, position: [0.01, 0, 0.9]}
forces:
  - {type: contact, between: [ball, left], stiffness: 1.0e+4, exponent: 1, dissipation: 0}
  - {type: contact, between: [ball, right], stiffness: 1.0e+4, exponent: 1, dissipation: 0}
)");
  const Reference reference = contactReference(bench.world, bench.initial, 20, kBudget);
  EXPECT_LT(reference.known_until, 20);
  EXPECT_GT(reference.known_until, 0.5);
  EXPECT_GT(reference.doubt.bounded(), kBudget);
}

TEST(TradeProgram, RecommendsAToleranceForContactAndWritesIt) {
  const TemporaryDirectory files;
  const std::string path = files.written("ball.yaml", kElasticBall), directory = files.path("out");
  const test::Outcome run = test::runCommand(std::string(RIGID_BODY_SIM_TRADE) + " " + path +
                                             " --duration 1 --error-budget 1e-9 --write --out " +
                                             directory + " 2>/dev/null");
  ASSERT_EQ(run.exit_code, 0) << run.out;
  EXPECT_NE(run.out.find("\ntolerance: "), std::string::npos) << run.out;
  const Scene written = loadScene(path);
  EXPECT_TRUE(written.tolerance_stated);
  EXPECT_GT(written.tolerance, 1e-9);  // what the scene held to before, more than is asked for
  EXPECT_LT(written.tolerance, 1e-2);
  std::ifstream table(directory + "/trade.csv");
  std::string header, row;
  std::getline(table, header);
  std::getline(table, row);
  EXPECT_EQ(header.substr(header.rfind(',')), ",tolerance");
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), std::count(header.begin(), header.end(), ','));
}

}  // namespace rigid_body_sim
