#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/wrenches/held_wrench.hpp"
#include "math/sanitizers.hpp"
#include "support/ladder.hpp"
#include "support/method_cases.hpp"
#include "support/reference_bench.hpp"

namespace rigid_body_sim {
namespace {

using namespace test;  // cases and benches

class EveryMethod : public testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryMethod, testing::ValuesIn(catalogue()),
                         [](const auto& tested) { return std::string(tested.param.name); });

bool hasKink(const Case& c) {
  const ForceLaws& laws = c.bench.world.laws;
  return std::any_of(laws.begin(), laws.end(), [](const auto& law) { return law->hasKink(); });
}

// Within what the next term of the expansion leaves at those steps: a tenth of the order, and 0.1.
// A position that is exact for its wrench has no slope to show.
TEST_P(EveryMethod, ConvergesAtItsClaimedOrder) {
  const Method& method = GetParam();
  if (method.claimsTo(kSolves)) GTEST_SKIP() << "has no order, see below";
  constexpr double kDuration = 2;       // [s]
  constexpr double kMostInOneGo = 1.2;  // evaluations; more are short steps beside a kink
  for (const Case& c : casesFor(method)) {
    const int order = c.torque_free ? method.free_order : method.order;
    if (order == 0) continue;  // exact, see below
    const reference::Motions truth = test::referenceRun(c.bench, kDuration);
    Ladder attitude(1e-12), position(2e-11);  // some 100 times the rounding of these runs
    bool met_kink = false;
    std::optional<double> longest_smooth;  // error in the longest steps that meet no kink
    for (double steps = 5; steps < 5000; steps *= 1.5) {
      const int n = static_cast<int>(steps);
      Simulation sim = c.bench.simulation(method.name, kDuration / n);
      for (int i = 0; i < n; ++i) sim.step();
      // other steps were taken than asked for, some of them beside a kink
      const bool meets_kink = hasKink(c) && static_cast<double>(sim.evaluations()) >
                                                kMostInOneGo * n * method.evaluations;
      if (sim.maxSubsteps() > 1 || meets_kink) {
        met_kink = met_kink || meets_kink;
        continue;
      }
      const auto errors = test::motionErrors(sim.state(), truth);
      attitude.add(n, errors.attitude);
      position.add(n, errors.position);
      if (met_kink && !longest_smooth) longest_smooth = errors.attitude;
    }
    if (longest_smooth && !attitude.slope(2)) {
      // all shorter ones err by rounding, as the order lets it fall that fast from rung to rung
      EXPECT_LT(*longest_smooth, 1e-12 * std::pow(1.5, method.order + 1)) << c.name;
      continue;
    }
    ASSERT_TRUE(attitude.slope(2)) << c.name;
    EXPECT_NEAR(*attitude.slope(2), order, 0.1 * order + 0.1) << c.name;
    // over more of the ladder: the error of a position may pass through zero
    EXPECT_GT(position.slope(4).value_or(100), 0.9 * method.order - 0.1) << c.name;
  }
}

// Rounding of the few hundred steps, grown by a motion that spins up to some 10 rad/s.
TEST_P(EveryMethod, SolvesWhateverTheStepIfItSaysSo) {
  const Method& method = GetParam();
  for (const Case& c : casesFor(method)) {
    if (!method.claimsTo(kSolves) && !(c.torque_free && method.free_order == 0)) continue;
    const reference::Motions truth = test::referenceRun(c.bench, 2);
    for (int n : {1, 7, 300}) {
      const auto errors = test::motionErrors(c.bench.run(method.name, 2, n), truth);
      EXPECT_LT(errors.attitude, 2e-13) << c.name << " in " << n << " steps";
      EXPECT_LT(errors.position, 2e-13 * 20) << c.name << " in " << n << " steps";
    }
  }
}

// Within a factor of 2: the two runs tell the leading term of the error, and what is measured is
// the error at the end against the greatest of the run.
TEST_P(EveryMethod, TellsItsErrorFromARunAtTwiceTheStep) {
  const Method& method = GetParam();
  if (method.claimsTo(kSolves)) GTEST_SKIP() << "errs by rounding";
  for (const Case& c : casesFor(method)) {
    if (c.torque_free) continue;  // has an order of its own
    const int steps = method.order >= 6 ? 80 : 400;
    Simulation sim = c.bench.simulation(method.name, 2.0 / steps);
    sim.trackError();
    double worst = 0;
    for (int i = 1; i <= steps; ++i) {
      sim.step();
      if (i % (steps / 4) == 0)
        worst = std::max(
            worst,
            test::motionErrors(sim.state(), test::referenceRun(c.bench, sim.time())).attitude);
    }
    if (worst < 1e-12) continue;  // rounding
    EXPECT_GT(sim.errorEstimate().attitude, worst / 2) << c.name;
    EXPECT_LT(sim.errorEstimate().attitude, worst * 4) << c.name;
  }
}

/// The first body of a world, under one wrench.
System systemUnder(const World& world, const PointWrench& wrench) {
  HeldWrenchSum sum;
  sum.add(wrench);
  System system;
  system.bodies = {&world.bodies[0]};
  system.held = {sum.sum()};
  return system;
}

TEST_P(EveryMethod, EvaluatesWrenchesAsOftenAsItClaims) {
  const Method& method = GetParam();
  const Bench bench = test::pushedBox(kWorld, 0);
  const System system = systemUnder(bench.world, bench.world.wrenches[0]);
  SystemState states{bench.initial.bodies, {}};
  Workspace workspace;
  method.step(system, 0.01, states, workspace);
  const std::int64_t first = workspace.evaluations;
  for (int i = 0; i < 10; ++i) method.step(system, 0.01, states, workspace);
  EXPECT_EQ(workspace.evaluations - first, 10 * method.evaluations);
}

/// [s] A step that turns a body of about 2 rad/s by half of what the method follows in one substep:
/// what the method gets wrong is then well above rounding.
double longStep(const Method& method) { return 0.5 * std::min(method.max_turn, 1.6) / 2; }

// There and back over 50 steps each way: rounding of about 1e-16 a step, grown by the motion.
TEST_P(EveryMethod, IsReversibleIfAndOnlyIfItSaysSo) {
  const Method& method = GetParam();
  if (method.claimsTo(kSolves)) GTEST_SKIP() << "steps forwards only; the error is rounding";
  Bench bench = freeBody();
  PointWrench push;
  push.point = {0.1, 0.2, 0.3};
  push.force = {1, 0, 0.5};
  const System system = systemUnder(bench.world, push);
  SystemState states{bench.initial.bodies, {}};
  Workspace workspace;
  for (double h : {longStep(method), -longStep(method)})
    for (int i = 0; i < 50; ++i) method.step(system, h, states, workspace);
  const double error = angleBetween(states.bodies[0].q_WP, bench.initial.bodies[0].q_WP);
  EXPECT_EQ(error < 1e-11, method.claimsTo(kReversible)) << error;
}

TEST_P(EveryMethod, KeepsAngularMomentumToTheLastBitIfItSaysSo) {
  const Method& method = GetParam();
  const Bench bench = freeBody();
  const State end = bench.run(method.name, 10, 1000);
  EXPECT_EQ(end.bodies[0].L_W == bench.initial.bodies[0].L_W, method.claimsTo(kKeepsFreeL));
  EXPECT_EQ(end.bodies[0].p_W, bench.initial.bodies[0].p_W);
}

#if defined(RIGID_BODY_SIM_ADDRESS_SANITIZER)
constexpr int kLongRun = 20000;  // steps; sanitizers look at the code, not at the drift
#else
constexpr int kLongRun = 200000;
#endif

// Over ten times the time a bounded error stays, a drifting one grows about tenfold. The lecture's
// update drifts so fast that only short steps show it before the energy is at its greatest.
TEST_P(EveryMethod, BoundsTheEnergyErrorIfItSaysSo) {
  const Method& method = GetParam();
  if (method.claimsTo(kSolves)) GTEST_SKIP() << "the error is rounding";
  const Bench bench = freeBody();
  const Body& body = bench.world.bodies[0];
  const double E_0 = kineticEnergy(body, bench.initial.bodies[0]);
  Simulation sim = bench.simulation(method.name, method.order == 1 ? 1e-4 : longStep(method));
  double early = 0, late = 0;
  for (int i = 0; i < kLongRun; ++i) {
    sim.step();
    double& worst = i < kLongRun / 10 ? early : late;
    worst = std::max(worst, std::abs(kineticEnergy(body, sim.body(0)) - E_0));
  }
  // what rounding adds up to, at 1e-15 a step: 2e-10 over 200 000 steps of up to fifteen drifts
  const double rounding = 1e-15 * kLongRun;
  EXPECT_EQ(late < std::max(1.5 * early, rounding), method.claimsTo(kBoundsEnergy))
      << early << " then " << late;
}

// The OSRF box: angular momentum to the last bit, energy to 1e-6, position to rounding.
TEST(Strang, FollowsTheComplexBox) {
  const Bench bench = test::complexBox();
  const Body& body = bench.world.bodies[0];
  const BodyState& start = bench.initial.bodies[0];
  const auto energy = [&](const BodyState& s) {
    return kineticEnergy(body, s) - body.mass * bench.world.g_W.dot(s.x_W);
  };
  // published: 368.5464125 J, with moments of inertia rounded to five digits
  EXPECT_NEAR(energy(start), 368.5464125, 0.5 * 5 * 5 * 5e-6);
  Simulation sim = bench.simulation("strang", 1e-3);
  for (int i = 0; i < 10000; ++i) {
    sim.step();
    const BodyState& s = sim.body(0);
    const double t = sim.time();
    EXPECT_EQ(s.L_W, start.L_W);
    EXPECT_NEAR(energy(s), energy(start), 1e-6 * energy(start));
    const Vector3d parabola = t * Vector3d(-2, 2, 8) + 0.5 * t * t * bench.world.g_W;
    // 1e-12 of the path so far; the parabola itself is rounded to an ulp of 410 m
    EXPECT_LE((s.x_W + s.x_low_W - parabola).norm(), 1e-12 * (1 + parabola.norm()));
  }
}

TEST(Rk4, ShowsItsEnergyDrift) {
  const Bench bench = freeBody();
  const State coarse = bench.run("rk4", 10, 500);
  EXPECT_GT(std::abs(kineticEnergy(bench.world.bodies[0], coarse.bodies[0]) -
                     kineticEnergy(bench.world.bodies[0], bench.initial.bodies[0])),
            1e-12);
}

}  // namespace
}  // namespace rigid_body_sim
