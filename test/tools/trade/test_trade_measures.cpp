#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "support/trade_settings.hpp"
#include "support/trade_worlds.hpp"
#include "tools/common/state_at.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;
using test::countedCost;
using test::SpringWorld;

/// The symmetric top turns about L at |L|/I₁ and about its own axis at ω₃ (1 − I₃/I₁).
Quaterniond topAttitude(const BodyState& start, const Vector3d& I, double t) {
  const double spin = start.L_P[2] / I[2] * (1 - I[2] / I[0]) * t;
  const Vector3d L_W = rotate(start.q_WP, start.L_P);
  return Eigen::AngleAxisd(L_W.norm() / I[0] * t, L_W.normalized()) * start.q_WP *
         Eigen::AngleAxisd(spin, Vector3d::UnitZ());
}

void expectWithinAFactorOfTwo(double reported, double truth, const std::string& what) {
  constexpr double kFloor = 1e-12;  // below it, rounding of the closed forms themselves counts
  if (reported < kFloor && truth < kFloor) return;
  EXPECT_LE(reported, 2 * truth) << what;
  EXPECT_GE(reported, 0.5 * truth) << what;
}

/// Compares, for every integrator, what is reported with the closed form truth(state): the greatest
/// over the instants of the reference.
template <class Truth, class Reported>
void expectTruth(const Bench& bench, double duration, double step, const Truth& truth,
                 const Reported& reported) {
  const Reference reference = computeReference(bench.world, bench.initial, duration);
  for (const std::string& integrator : integratorsFor(bench.world, bench.initial)) {
    const Setting setting =
        measureSetting(bench.world, reference, integrator, step, {test::kBriefly, 0});
    Simulation simulation = bench.simulation(integrator, step);
    double worst = 0;
    for (std::size_t k = 1; k < reference.states.size(); ++k)
      worst = std::max(worst, truth(stateAt(simulation, reference.states[k].t)));
    expectWithinAFactorOfTwo(reported(setting.errors), worst, integrator);
  }
}

/// A random world with what trade measures on it.
struct MeasuredWorld {
  explicit MeasuredWorld(unsigned seed) : world(test::randomWorld(seed)) {
    world.bench.world.solver = {"auto", kStep, 1e-9, kDuration};
    reference = computeReference(world.bench.world, world.bench.initial, kDuration);
    settings = test::ladders(world.bench.world, world.bench.initial, reference);
    truth = test::referenceRun(world, kDuration);
  }

  static constexpr double kDuration = 2, kStep = 0.01;  // [s]
  SpringWorld world;
  Reference reference;
  std::vector<Setting> settings;
  reference::Motions truth;
};

/// Ten of them, measured once for all tests.
const std::vector<MeasuredWorld>& measuredWorlds() {
  static const std::vector<MeasuredWorld> worlds = [] {
    std::vector<MeasuredWorld> all;
    for (unsigned seed = 0; seed < 10; ++seed) all.emplace_back(seed);
    return all;
  }();
  return worlds;
}

}  // namespace

TEST(Trade, ReportsTheAttitudeErrorOfASymmetricTop) {
  Bench bench;
  bench.add(test::principalBody("top", 1, {1, 1, 1.5}), test::tumbling({1, 0, 0}, {0.6, 0, 2}));
  const BodyState start = bench.initial.bodies[0];
  const Vector3d I = bench.world.bodies[0].I;
  for (double step : {0.2, 0.02})
    expectTruth(
        bench, 4, step,
        [&](const State& s) { return angleBetween(s.bodies[0].q_WP, topAttitude(start, I, s.t)); },
        [](const Errors& e) { return e.attitude; });
}

TEST(Trade, ReportsThePositionErrorOfAHarmonicSpring) {
  // tied at the centre of mass, without rest length: x = x₀ cos Ωt + v₀/Ω sin Ωt, on an ellipse
  Bench bench;
  bench.add(test::principalBody("ball", 2, {1, 2, 2.5}), test::tumbling({0, 3, 0}, {0.1, 1, 0.2}));
  bench.initial.bodies[0].x_W = {1, 0, 0};
  bench.world.laws = {std::make_shared<Spring>(Spring::End{0, Vector3d::Zero()}, Spring::End(),
                                               Spring::Constants{18, 0, 0})};
  const auto at = [](double t) -> Vector3d { return {std::cos(3 * t), std::sin(3 * t), 0}; };
  for (double step : {0.1, 0.01})
    expectTruth(
        bench, 4, step,
        // on the unit circle at 3 m/s, the path is 3 t
        [&](const State& s) { return (s.bodies[0].x_W - at(s.t)).norm() / (3 * s.t); },
        [](const Errors& e) { return e.position; });
}

TEST(Trade, KnowsHowGoodItsReferenceIs) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const SpringWorld world = test::randomWorld(seed);
    constexpr double kDuration = 2;
    const Reference reference = computeReference(world.bench.world, world.bench.initial, kDuration);
    const test::MotionErrors errors =
        test::motionErrors(reference.states.back(), test::referenceRun(world, kDuration));
    EXPECT_LE(errors.attitude, std::max(2 * reference.doubt.attitude, 1e-15)) << seed;
    EXPECT_LT(reference.doubt.bounded(), 1e-11) << seed;
  }
}

TEST(Trade, RecommendsSettingsThatMeetTheBudget) {
  for (const MeasuredWorld& m : measuredWorlds()) {
    for (double budget : {1e-3, 1e-6, 1e-9}) {
      const SolverOptions& scene = m.world.bench.world.solver;
      const Setting* best = cheapestWithin(m.settings, m.reference, budget, scene);
      ASSERT_NE(best, nullptr) << budget;
      Simulation simulation = m.world.bench.simulation(best->integrator, best->time_step);
      const State end = stateAt(simulation, MeasuredWorld::kDuration);
      EXPECT_LE(test::motionErrors(end, m.truth).attitude, budget)
          << best->integrator << ' ' << best->time_step;
    }
  }
}

TEST(Trade, FindsThatAutoHoldsItsToleranceAtTwiceTheLeastCost) {
  constexpr double kStep = MeasuredWorld::kStep;
  for (const MeasuredWorld& m : measuredWorlds()) {
    for (double tolerance : {1e-3, 1e-6, 1e-9}) {
      Bench bench = m.world.bench;
      bench.world.solver.tolerance = tolerance;
      Simulation simulation = bench.simulation("auto", kStep);
      const State end = stateAt(simulation, MeasuredWorld::kDuration);
      EXPECT_LE(test::motionErrors(end, m.truth).attitude, tolerance);

      const std::string integrator = simulation.plans()[0].integrator;
      if (integrator.empty()) continue;  // solved: the cost of a step is none of the catalogue's
      EXPECT_LE(countedCost(methodNamed(integrator), simulation.evaluations()),
                2 * test::leastCost(m.settings, kStep, tolerance))
          << tolerance << ' ' << integrator;
    }
  }
}

TEST(Trade, AdviceDoesNotDependOnTheTimesThatWereMeasured) {
  const auto setting = [](const std::string& integrator, double time_step, double work) {
    Setting s;
    s.integrator = integrator;
    s.time_step = time_step;
    s.work = work;
    return s;
  };
  // auto divides longer steps into as many substeps: equal work, and times that differ by noise
  std::vector<Setting> settings{setting("rk4", 0.02, 50), setting("auto", 0.04, 20),
                                setting("auto", 0.08, 20), setting("rk4", 0.04, 25)};
  std::vector<double> times{1, 2, 3, 4};
  SolverOptions scene;
  scene.integrator = "auto";
  scene.time_step = 0.005;
  do {
    for (std::size_t i = 0; i < times.size(); ++i) settings[i].cpu_ns_per_sim_s = times[i];
    const Setting* best = cheapestWithin(settings, Reference(), 1e-6, scene);
    ASSERT_NE(best, nullptr);
    EXPECT_EQ(best->integrator, "auto");
    EXPECT_EQ(best->time_step, 0.04);
  } while (std::next_permutation(times.begin(), times.end()));
}

TEST(TradeMeasures, LeaveOutABodyThatIsAbsent) {
  Bench alone;
  alone.world.g_W = {0, 0, -9.81};
  alone.add(test::principalBody("box", 2, {1, 2, 2.5}), test::tumbling({0, 0, 1}, {2, 1, 0.2}));
  Bench with_guest = alone;
  with_guest.add(test::principalBody("guest", 2e3, {1, 2, 2.5}),
                 test::tumbling({0, 0, 9}, {2, 1, 0.2}));
  with_guest.world.bodies[1].absent = true;
  const auto measured = [](const Bench& bench) {
    const Reference reference = computeReference(bench.world, bench.initial, 1);
    return measureSetting(bench.world, reference, "rk4", 0.05, {test::kBriefly, 0}).errors;
  };
  const Errors expected = measured(alone), errors = measured(with_guest);
  EXPECT_GT(expected.energy, 0);
  EXPECT_EQ(errors.energy, expected.energy);
  EXPECT_EQ(errors.attitude, expected.attitude);
  EXPECT_EQ(errors.position, expected.position);
  EXPECT_EQ(movingBodyCount(with_guest.world), 1);
}

// Whatever the step, such a run is a part of one.
TEST(TradeMeasures, ShowTheErrorOfARunShorterThanAStep) {
  constexpr double kG = 9.81, kSpeed = 2;
  Bench bench;
  bench.world.g_W = {0, 0, -kG};
  bench.add(test::principalBody("box", 2, {1, 2, 2.5}), test::tumbling({0, 0, 1}, {2, 1, 0.2}));
  bench.initial.bodies[0].p_W = Vector3d(2 * kSpeed, 0, 0);
  for (const double duration : {1e-15, 1e-9, 1e-6, 1e-3}) {
    const Reference reference = computeReference(bench.world, bench.initial, duration);
    for (const std::string& integrator : integratorsFor(bench.world, bench.initial)) {
      const auto errors_at = [&](double step) {
        return measureSetting(bench.world, reference, integrator, step, {test::kBriefly, 0}).errors;
      };
      const Errors whole = errors_at(0.01), quarter = errors_at(0.0025);
      EXPECT_EQ(whole.attitude, quarter.attitude) << integrator << ", " << duration << " s";
      EXPECT_EQ(whole.position, quarter.position) << integrator << ", " << duration << " s";
      // it turns by a few times the duration [rad], and a run that has not begun lacks its path
      EXPECT_LE(whole.attitude, 1e-3 * duration + 1e-14) << integrator << ", " << duration << " s";
      // it falls with the speed of the end instead of the mean one: by g t²/2 on a path of v t
      const double most = integrator == "semi_implicit_euler" ? kG * duration / (2 * kSpeed) : 0;
      EXPECT_LE(whole.position, most * (1 + 1e-3) + 1e-9) << integrator << ", " << duration << " s";
      if (duration >= 1e-6) {  // below, that is less than what rounding may be
        EXPECT_GE(whole.position, most * (1 - 1e-2)) << integrator << ", " << duration << " s";
      }
    }
  }
}

TEST(TradeMeasures, SayWhyNoneOfThemCanBeDrawn) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto fault_of = [](double cost, double error) {
    Setting setting;
    setting.cpu_ns_per_sim_s = cost;
    setting.errors.position = error;
    EXPECT_EQ(canBeDrawn(setting), pictureFault({setting}).empty());
    return pictureFault({setting, setting});
  };
  EXPECT_EQ(fault_of(1e3, 0), "");
  EXPECT_EQ(fault_of(1e3, 1e-3), "");
  const std::string coarse = "the clock of processor time is too coarse for runs as short as these";
  for (const double cost : {0.0, -1e3, kInfinity}) EXPECT_EQ(fault_of(cost, 0), coarse) << cost;
  EXPECT_EQ(fault_of(1e3, kInfinity), "no setting has an error that is finite");
  // one is enough
  Setting drawn, timeless;
  drawn.cpu_ns_per_sim_s = 1;
  EXPECT_EQ(pictureFault({timeless, drawn}), "");
}

}  // namespace rigid_body_sim
