#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/run/position_rounding.hpp"
#include "support/scene_bench.hpp"
#include "support/trade_settings.hpp"
#include "tools/common/state_at.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;

/// Those that the independent reference can follow: it knows neither contact nor motors and
/// tethers.
std::vector<std::string> shippedScenes() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(RIGID_BODY_SIM_SCENES)) {
    if (file.path().extension() != ".yaml") continue;
    std::ostringstream text;
    text << std::ifstream(file.path()).rdbuf();
    const auto holds = [&](const char* key) { return text.str().find(key) != std::string::npos; };
    if (!holds("type: contact") && !holds("type: tether") && !holds("commands:"))
      names.push_back(file.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// A shipped scene over a hundred of its steps, and its motion by the independent reference.
class ShippedScene : public testing::TestWithParam<std::string> {
 protected:
  static constexpr int kSteps = 100;

  ShippedScene()
      : bench(test::sceneBench(std::string(RIGID_BODY_SIM_SCENES) + "/" + GetParam() + ".yaml")) {
    SolverOptions& solver = bench.world.solver;
    duration = solver.horizon = std::min(solver.horizon, kSteps * solver.time_step);
    reference = computeReference(bench.world, bench.initial, duration);
    settings = test::ladders(bench.world, bench.initial, reference);
    truth = test::referenceRun(bench, duration);
  }

  /// What a tolerance bounds, at the end: attitude [rad] and position over path, the worst.
  double errorOf(const State& state) const {
    double worst = 0;
    const std::vector<double> rounding = positionRounding(bench.world, state.bodies, state.laws);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      double path = 0;
      for (std::size_t k = 1; k < reference.states.size(); ++k)
        path += (reference.states[k].bodies[i].x_W - reference.states[k - 1].bodies[i].x_W).norm();
      State of_one;
      of_one.bodies = {state.bodies[i]};
      const test::MotionErrors errors = test::motionErrors(of_one, {truth[i]});
      const double gap = std::max(0.0, errors.position - rounding[i]);
      worst = std::max({worst, errors.attitude, path > 0 ? gap / path : gap});
    }
    return worst;
  }

  State run(const std::string& integrator, double time_step) const {
    Simulation simulation = bench.simulation(integrator, time_step);
    return stateAt(simulation, duration);
  }

  Bench bench;
  double duration;  // [s]
  Reference reference;
  std::vector<Setting> settings;
  reference::Motions truth;
};

INSTANTIATE_TEST_SUITE_P(Trade, ShippedScene, testing::ValuesIn(shippedScenes()),
                         [](const auto& scene) { return scene.param; });

}  // namespace

TEST_P(ShippedScene, KeepsTheBudgetWithTheSettingRecommended) {
  for (double budget : {1e-3, 1e-6, 1e-9}) {
    const Setting* best = cheapestWithin(settings, reference, budget, bench.world.solver);
    ASSERT_NE(best, nullptr) << budget;
    EXPECT_LE(errorOf(run(best->integrator, best->time_step)), budget)
        << best->integrator << ' ' << best->time_step;
  }
}

TEST_P(ShippedScene, KeepsItsToleranceWithAutoAtTwiceTheLeastCost) {
  const double step = bench.world.solver.time_step;
  for (double tolerance : {1e-3, 1e-6, 1e-9}) {
    bench.world.solver.tolerance = tolerance;
    Simulation simulation = bench.simulation("auto", step);
    EXPECT_LE(errorOf(stateAt(simulation, duration)), tolerance);

    double cost = 0;
    for (const MotionPlan& plan : simulation.plans())
      if (!plan.integrator.empty())
        cost += test::countedCost(methodNamed(plan.integrator), plan.evaluations);
    const double least = test::leastCost(settings, step, tolerance);
    EXPECT_TRUE(std::isfinite(least)) << tolerance;
    EXPECT_LE(cost, 2 * least) << tolerance;
  }
}

}  // namespace rigid_body_sim
