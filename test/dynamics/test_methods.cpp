#include <cmath>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "support/reference_bench.hpp"
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

class EveryMethod : public testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryMethod, testing::ValuesIn(catalogue()),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Errors over a ladder of steps, down to where rounding begins to show.
class Ladder {
 public:
  explicit Ladder(double floor) : floor_(floor) {}

  void add(int steps, double error) {
    done_ = done_ || error < floor_;
    if (done_) return;
    if (last_error_ > 0)
      slope_ = -std::log(error / last_error_) / std::log(static_cast<double>(steps) / last_steps_);
    last_error_ = error;
    last_steps_ = steps;
  }
  /// Of log error against log step, between the two finest; nothing when all is rounding.
  std::optional<double> slope() const { return slope_; }

 private:
  double floor_, last_error_ = 0, last_steps_ = 0;
  bool done_ = false;
  std::optional<double> slope_;
};

// Within what the next term of the expansion leaves at those steps: a tenth of the order, and 0.1.
// A position that is exact for its wrench has no slope to show.
TEST_P(EveryMethod, ConvergesAtItsClaimedOrder) {
  const Method& method = GetParam();
  constexpr double kDuration = 2;  // [s]
  for (const Case& c : cases()) {
    const int order = c.torque_free ? method.free_order : method.order;
    const reference::Motions truth = test::referenceRun(c.bench, kDuration);
    Ladder attitude(1e-12), position(2e-11);  // some 100 times the rounding of these runs
    for (double steps = 5; steps < 5000; steps *= 1.5) {
      const int n = static_cast<int>(steps);
      Simulation sim = c.bench.simulation(method.name, kDuration / n);
      for (int i = 0; i < n; ++i) sim.step();
      if (sim.mostParts() > 1) continue;  // other steps were taken than asked for
      const auto errors = test::motionErrors(sim.state(), truth);
      attitude.add(n, errors.attitude);
      position.add(n, errors.position);
    }
    ASSERT_TRUE(attitude.slope()) << c.name;
    EXPECT_NEAR(*attitude.slope(), order, 0.1 * order + 0.1) << c.name;
    EXPECT_GT(position.slope().value_or(100), 0.9 * method.order - 0.1) << c.name;
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
  EXPECT_EQ(error < 1e-11, method.claims_to(kReversible)) << error;
}

TEST_P(EveryMethod, KeepsAngularMomentumToTheLastBitIfItSaysSo) {
  const Method& method = GetParam();
  const Bench bench = freeBody();
  const State end = bench.run(method.name, 10, 1000);
  EXPECT_EQ(end.bodies[0].L_W == bench.initial.bodies[0].L_W, method.claims_to(kKeepsFreeL));
  EXPECT_EQ(end.bodies[0].p_W, bench.initial.bodies[0].p_W);
}

// Over ten times the time a bounded error stays, a drifting one grows about tenfold. The lecture's
// update drifts so fast that only short steps show it before the energy is at its greatest.
TEST_P(EveryMethod, BoundsTheEnergyErrorIfItSaysSo) {
  const Method& method = GetParam();
  const Bench bench = freeBody();
  const Body& body = bench.world.bodies[0];
  const double E_0 = kineticEnergy(body, bench.initial.bodies[0]);
  Simulation sim = bench.simulation(method.name, method.order == 1 ? 1e-4 : longStep(method));
  double early = 0, late = 0;
  for (int i = 0; i < 20000; ++i) {
    sim.step();
    double& worst = i < 2000 ? early : late;
    worst = std::max(worst, std::abs(kineticEnergy(body, sim.state().bodies[0]) - E_0));
  }
  EXPECT_EQ(late < 1.5 * early, method.claims_to(kBoundsEnergy)) << early << " then " << late;
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
