#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/contact_benches.hpp"
#include "support/law_benches.hpp"
#include "support/motor_benches.hpp"
#include "support/random_inputs.hpp"
#include "support/refusal.hpp"
#include "support/same_state.hpp"
#include "support/worlds.hpp"

/// A run that goes on from a state, whatever acts, is to come and has happened before.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::RandomInputs;

constexpr double kLoadStep = 0.01;

void runTo(Simulation& sim, std::int64_t end, RandomInputs inputs) {
  while (sim.steps() < end) {
    inputs.apply(sim);
    sim.step();
  }
}

/// Cuts a run at random steps and goes on in a run that has been elsewhere.
void expectSameBitsFromCuts(const Simulation& start, std::int64_t end, unsigned seed) {
  const RandomInputs inputs(seed);
  Simulation whole = start;
  std::vector<State> cuts;
  std::mt19937 random(seed);
  std::vector<bool> is_cut(static_cast<std::size_t>(end));
  for (int i = 0; i < 20; ++i) is_cut[random() % is_cut.size()] = true;
  for (const bool cut : is_cut) {
    if (cut) cuts.push_back(whole.state());
    runTo(whole, whole.steps() + 1, inputs);
  }
  Simulation elsewhere = start;
  runTo(elsewhere, 15, RandomInputs(seed + 1));
  for (const State& cut : cuts) {
    SCOPED_TRACE(cut.t);
    elsewhere.load(cut);
    test::expectSameState(elsewhere.state(), cut);
    runTo(elsewhere, end, inputs);
    test::expectSameState(elsewhere.state(), whole.state());
    if (!inputs.resets()) {  // which would lead it back to the cut
      Simulation anew(start.world(), cut);
      runTo(anew, end, inputs);
      test::expectSameState(anew.state(), whole.state());
    }
    if (::testing::Test::HasFailure()) return;
  }
}

Bench threeBodies() {
  Bench bench;
  for (const char* name : {"a", "b", "c"})
    bench.add(test::principalBody(name, 2, {1, 2, 2.5}), test::tumbling({0, 0, 0}, {0.5, 1, 0.2}));
  PointWrench scheduled = test::worldForce({1, 2, 3}, 0.203, 0.717);
  scheduled.body = 1;
  bench.world.wrenches.push_back(scheduled);
  return bench;
}

Bench ballsAndBox() {
  Bench bench = test::stackedBalls(0.02, 0.01);
  test::addBox(bench, {0.2, 0.3, 0.1}, 1, test::motionAt({2, 0, 0.06}), HalfSpace{},
               test::contactOf(1e4, 1.5, 0.5, 0.3));
  return bench;
}

Bench mixedBench() {
  Bench bench = test::benchOf(test::motley(), test::motleyStart());
  bench.add(test::principalBody("passenger", 2, {1, 2, 2.5}), BodyFrameMotion());
  bench.world.commands = {test::commandOf(1, -30, 0.105), test::commandOf(3, 0.2, 0.251)};
  return bench;
}

}  // namespace

TEST(Load, GoesOnWithTheBitsOfTheRunUnderWrenches) {
  for (unsigned seed : {1, 2, 3, 4})
    expectSameBitsFromCuts(threeBodies().simulation("auto", kLoadStep), 100, seed);
  expectSameBitsFromCuts(threeBodies().simulation("dop853", kLoadStep), 60, 8);
}

TEST(Load, GoesOnWithTheBitsOfTheRunWithMotors) {
  for (unsigned seed : {1, 2, 3, 4})
    expectSameBitsFromCuts(mixedBench().simulation("auto", kLoadStep), 100, seed);
}

TEST(Load, GoesOnWithTheBitsOfTheRunInContact) {
  for (unsigned seed : {2, 3})
    expectSameBitsFromCuts(ballsAndBox().simulation("auto", kLoadStep), 60, seed);
}

TEST(Load, GoesOnWithTheBitsOfTheRunThatHasGoneToRest) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.world.solver.tolerance = 1e-6;
  ContactParameters damped = test::contactOf(1e5, 1.5, 3, 0.5);
  damped.breakaway = 1e-4;
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, test::motionAt({0, 0, 0.1}), HalfSpace{}, damped);
  Simulation whole = bench.simulation("auto", kLoadStep), rest = whole;
  while (whole.time() < 5 && !whole.plans()[0].at_rest) whole.step();
  ASSERT_TRUE(whole.plans()[0].at_rest);
  rest.load(whole.state());
  EXPECT_TRUE(rest.plans()[0].at_rest);
  for (Simulation* sim : {&whole, &rest}) {
    sim->applyWrench("push", test::worldForce({40, 0, 0}, sim->time() + 0.123, 99));
    for (int i = 0; i < 30; ++i) sim->step();
  }
  EXPECT_FALSE(whole.plans()[0].at_rest);
  test::expectSameState(rest.state(), whole.state());
}

// what looks for contacts of balls stops no body that has none
TEST(Load, DoesNotDependOnBodiesThatATouchCannotReach) {
  Bench alone, with_balls;
  for (Bench* bench : {&alone, &with_balls}) {
    bench->world.g_W = {0, 0, -9.81};
    bench->world.solver.tolerance = 1e-4;
    test::addBox(*bench, {0.2, 0.3, 0.1}, 1, test::motionAt({2, 0, 0.06}), HalfSpace{},
                 test::contactOf(1e4, 1.5, 0.5, 0.3));
  }
  for (const double x : {-5.0, 5.0})
    with_balls.add(test::principalBody("ball" + std::to_string(x), 2, {1, 1, 1}),
                   test::motionAt({x, 0, 9}));
  with_balls.world.laws.push_back(contactOfBalls(with_balls.world.bodies, 1, test::ballShape(0.1),
                                                 2, test::ballShape(0.1),
                                                 test::contactOf(1e4, 1.5, 0.5, 0.3)));
  Simulation a = alone.simulation("auto", kLoadStep), b = with_balls.simulation("auto", kLoadStep);
  for (int i = 0; i < 30; ++i) {
    a.step();
    b.step();
    test::expectSameBodyState(b.body(0), a.body(0));
  }
}

// The wrench that linked a with b has given way to one that does not: they part at once.
TEST(Load, FindsBodiesPartedThatAWrenchLinksNoMore) {
  Simulation sim = threeBodies().simulation("auto", kLoadStep);
  PointWrench push = test::worldForce({1, 2, 3}, 0, 9);
  push.axes = 1;
  sim.applyWrench("push", push);
  sim.step();
  EXPECT_EQ(sim.plans().size(), 2u);
  push.axes = kWorld;
  sim.applyWrench("push", push);
  EXPECT_EQ(sim.plans().size(), 3u);
}

// In the axes of a body that stands still, on one that slides without friction.
TEST(Load, FindsAWrenchActingThatLinksABodyInContact) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, test::motionAt({0, 0, 0.1}), HalfSpace{},
               test::contactOf(1e5, 1.5, 3, 0));
  bench.add(test::principalBody("other", 2, {1, 2, 2.5}), test::motionAt({9, 0, 0}));
  PointWrench push = test::worldForce({3, 0, 0}, 0.105, 0.205);
  push.axes = 1;
  bench.world.wrenches.push_back(push);
  Simulation sim = bench.simulation("auto", kLoadStep);
  while (sim.steps() < 15) sim.step();
  sim.load(sim.state());
  while (sim.steps() < 30) sim.step();
  EXPECT_NEAR(sim.body(0).p_W.x(), 0.3, 1e-6);
}

TEST(Load, LeavesTheStartToAReset) {
  const Simulation start = threeBodies().simulation("auto", kLoadStep);
  Simulation sim = start;
  runTo(sim, 50, RandomInputs(2));
  const State middle = sim.state();
  Simulation loaded = start;
  loaded.load(middle);
  loaded.reset(true);
  test::expectSameState(loaded.state(), start.state());
}

// the box is in the air, where its motion is solved
TEST(Load, RefusesAnIntegratorThatCannotFollowWhatIsToCome) {
  Simulation sim = ballsAndBox().simulation("auto", kLoadStep);
  sim.step();
  State state = sim.state();
  MotionPlan& box = state.plans.back();
  ASSERT_TRUE(box.laws.empty() && !box.waiting_laws.empty() && box.integrator.empty());
  for (const char* integrator : {"strang", "taylor"}) {
    box.integrator = integrator;
    const std::string refusal = test::refusalOf([&] { sim.load(state); });
    EXPECT_NE(refusal.find(integrator), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("contact"), std::string::npos) << refusal;
  }
  box.integrator = "dop853";
  sim.load(state);
  for (int i = 0; i < 100; ++i) sim.step();
}

TEST(Load, OfAStateThatIsRefusedChangesNothing) {
  Simulation sim = ballsAndBox().simulation("auto", kLoadStep);
  while (sim.steps() < 20) sim.step();
  sim.applyWrench("push", test::worldForce({1, 0, 0}, 0, 9));
  const State before = sim.state();
  const auto refusalOf = [&](const std::function<void(State&)>& change) -> std::string {
    State changed = before;
    change(changed);
    try {
      sim.load(changed);
    } catch (const std::invalid_argument& refused) {
      test::expectSameState(sim.state(), before);
      return refused.what();
    }
    return "taken";
  };
  EXPECT_EQ(refusalOf([](State&) {}), "taken");
  EXPECT_EQ(refusalOf([](State& s) { s.schedules[0].wrenches[0].wrench.force.x() = NAN; }),
            "wrench on body 'ball0': force, torque and point must be finite");
  EXPECT_EQ(refusalOf([](State& s) { s.schedules[0].wrenches[0].wrench.body = 1; }),
            "body 'ball0': its schedule must be of that body");
  EXPECT_EQ(refusalOf([](State& s) { s.anchors[2].state.p_W.x() = INFINITY; }),
            "body 'box2': momenta must be finite");
  EXPECT_EQ(refusalOf([](State& s) { s.anchors[2].t = 7; }),
            "body 'box2': its anchor must not be of the future");
  EXPECT_EQ(refusalOf([](State& s) { s.plans.pop_back(); }),
            "body 'box2': it must be in one group, got 0");
  EXPECT_EQ(refusalOf([](State& s) { s.plans.back().laws.clear(); }),
            "law 3 (contact): one plan must have it, once, as long as it acts");
  EXPECT_EQ(refusalOf([](State& s) { s.plans[0].integrator = "dop854"; }).substr(0, 10),
            "integrator");
  EXPECT_EQ(refusalOf([](State& s) { s.near_laws = {9}; }), "no law has the index 9");
  EXPECT_EQ(refusalOf([](State& s) {
              s.near_laws = {1, 1};
            }),
            "near_laws must be numbers that ascend");
  EXPECT_EQ(refusalOf([](State& s) { s.plans[0].substeps = 0; }),
            "group 0: must have at least one substep");
  EXPECT_EQ(refusalOf([](State& s) { s.plans[0].error = -1; }),
            "group 0: error must be >= 0, got -1");
  EXPECT_EQ(refusalOf([](State& s) { s.plans[0].bodies.clear(); }),
            "group 0: must name its bodies, in the order of the scene");
  EXPECT_EQ(refusalOf([](State& s) { s.plans[0].at_rest = true; }),
            "body 'ball0': its momenta must be zero, as its group is at rest");
  const auto endAt = [](double end) {
    return [end](State& s) { s.schedules[0].wrenches[0].wrench.end = end; };
  };
  EXPECT_EQ(refusalOf(endAt(0.01)).substr(0, 69),
            "wrench on body 'ball0': end must not be before its start, nor before ");
}

}  // namespace rigid_body_sim
