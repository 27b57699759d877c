#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/worlds.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;

struct Case {
  const char* name;
  Bench bench;
  bool torque_free = false;
};

Bench freeBody() {
  Bench bench;
  bench.add(test::principalBody("top", 1, {1, 2, 3}), test::tumbling({1, 2, 3}, {1, 1.5, 0.5}));
  return bench;
}

/// A body pushed in the axes and at a point of a second body, which tumbles freely.
Bench coupledBodies() {
  Bench bench = test::pushedBox(1, 1, 0.1);
  bench.add(test::principalBody("other", 3, {1, 2, 2.5}),
            test::tumbling({0.3, 0.1, 0}, {0.4, 1.2, -0.6}));
  return bench;
}

/// A wrench in the world that starts and ends inside a step.
Bench interruptedPush() {
  Bench bench = test::pushedBox(kWorld, 0, 0.1);
  bench.world.wrenches[0].start = 0.1234567;
  bench.world.wrenches[0].end = 0.7654321;
  return bench;
}

std::vector<Case> cases() {
  return {{"free", freeBody(), true},
          {"world_wrench_at_body_point", test::pushedBox(kWorld, 0, 0.1)},
          {"world_wrench_at_world_point", test::pushedBox(kWorld, kWorld, 0.1)},
          {"body_wrench_at_body_point", test::pushedBox(0, 0, 0.1)},
          {"body_wrench_at_world_point", test::pushedBox(0, kWorld, 0.1)},
          {"wrench_of_another_body", coupledBodies()},
          {"start_and_end_inside_steps", interruptedPush()}};
}

struct Errors {
  double attitude, position;
};

Errors errors(const State& a, const State& b) {
  Errors e{0, 0};
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    e.attitude = std::max(e.attitude, angleBetween(a.bodies[i].q_WP, b.bodies[i].q_WP));
    e.position = std::max(e.position, (a.bodies[i].x_W - b.bodies[i].x_W).norm());
  }
  return e;
}

class EveryMethod : public testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryMethod, testing::ValuesIn(catalogue()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// The slope of log error against log step over halved steps. Steps are chosen per order so that the
// error lies well above rounding and well below 1; 0.2 is what the next term of the expansion
// leaves at those steps.
TEST_P(EveryMethod, ConvergesAtItsClaimedOrder) {
  const Method& method = GetParam();
  for (const Case& c : cases()) {
    const int order = c.torque_free ? method.free_order : method.order;
    const int steps = order >= 8 ? 8 : order >= 4 ? 64 : 512;
    const State reference = c.bench.run("kahan_li8", 1, 512);
    const Errors coarse = errors(c.bench.run(method.name, 1, steps), reference);
    const Errors fine = errors(c.bench.run(method.name, 1, 2 * steps), reference);
    EXPECT_NEAR(std::log2(coarse.attitude / fine.attitude), order, 0.05 * order + 0.15) << c.name;
    // a position that is exact for this wrench has no order to show
    if (fine.position > 1e-11) {
      EXPECT_GT(std::log2(coarse.position / fine.position), method.order - 0.2) << c.name;
    }
  }
}

TEST_P(EveryMethod, EvaluatesWrenchesAsOftenAsItClaims) {
  const Method& method = GetParam();
  const Bench bench = test::pushedBox(kWorld, 0);
  System system;
  system.bodies = {&bench.world.bodies[0]};
  system.held.resize(1);
  system.held[0].add(bench.world.wrenches[0]);
  std::vector<BodyState> states = bench.initial.bodies;
  Workspace workspace;
  method.step(system, 0.01, states, workspace);
  const std::int64_t first = workspace.evaluations;
  for (int i = 0; i < 10; ++i) method.step(system, 0.01, states, workspace);
  EXPECT_EQ(workspace.evaluations - first, 10 * method.evaluations);
}

/// [s] A step that turns a body of about 2 rad/s by half of what the method follows in one part:
/// what the method gets wrong is then well above rounding.
double longStep(const Method& method) { return 0.5 * method.most_turn / 2; }

// There and back over 100 steps each way: rounding of about 1e-16 a step, grown by the motion.
TEST_P(EveryMethod, IsReversibleIfAndOnlyIfItSaysSo) {
  const Method& method = GetParam();
  Bench bench = freeBody();
  AppliedWrench push;
  push.point = {0.1, 0.2, 0.3};
  push.force = {1, 0, 0.5};
  System system;
  system.bodies = {&bench.world.bodies[0]};
  system.held.resize(1);
  system.held[0].add(push);
  std::vector<BodyState> states = bench.initial.bodies;
  Workspace workspace;
  for (double h : {longStep(method), -longStep(method)})
    for (int i = 0; i < 100; ++i) method.step(system, h, states, workspace);
  const double error = angleBetween(states[0].q_WP, bench.initial.bodies[0].q_WP);
  EXPECT_EQ(error < 1e-11, method.reversible) << error;
}

TEST_P(EveryMethod, KeepsAngularMomentumToTheLastBitIfItSaysSo) {
  const Method& method = GetParam();
  const Bench bench = freeBody();
  const State end = bench.run(method.name, 10, 1000);
  EXPECT_EQ(end.bodies[0].L_W == bench.initial.bodies[0].L_W, method.keeps_free_L);
  EXPECT_EQ(end.bodies[0].p_W, bench.initial.bodies[0].p_W);
}

// Over ten times the time a bounded error stays, a drifting one grows about tenfold.
TEST_P(EveryMethod, BoundsTheEnergyErrorIfItSaysSo) {
  const Method& method = GetParam();
  const Bench bench = freeBody();
  const Body& body = bench.world.bodies[0];
  const double E_0 = kineticEnergy(body, bench.initial.bodies[0]);
  Simulation sim = bench.simulation(method.name, longStep(method));
  double early = 0, late = 0;
  for (int i = 0; i < 20000; ++i) {
    sim.step();
    double& worst = i < 2000 ? early : late;
    worst = std::max(worst, std::abs(kineticEnergy(body, sim.state().bodies[0]) - E_0));
  }
  EXPECT_EQ(late < 1.5 * early, method.bounded_energy) << early << " then " << late;
}

// The two figures of the issue that this catalogue began with.
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
    const BodyState& s = sim.state().bodies[0];
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
