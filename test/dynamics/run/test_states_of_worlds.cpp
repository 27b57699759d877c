#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/line_force.hpp>
#include <rigid_body_sim/dynamics/totals.hpp>

#include "support/contact_benches.hpp"
#include "support/refusal.hpp"
#include "support/worlds.hpp"

/// A state that a program has changed, or that is of another world.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::refusalOf;

/// Of a body that tumbles under a torque, from a step at which its anchor lies back.
State tumblingAfter(Simulation sim) {
  for (int i = 0; i < 7; ++i) sim.step();
  return sim.state();
}

Simulation tumbling() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(test::principalBody("box", 2, {1, 2, 2.5}), test::tumbling({1, 0, 0}, {0.5, 1, 0.2}));
  bench.world.wrenches.push_back(test::worldForce({1, 2, 3}, 0, 9));
  return bench.simulation("auto", 0.01);
}

const std::vector<std::function<void(State&)>> kChanges{
    [](State& s) { s.bodies[0].x_W.x() += 1e-3; },
    [](State& s) {
      s.bodies[0].q_WP = product(rotationExp(Vector3d(0, 1e-3, 0)), s.bodies[0].q_WP);
    },
    [](State& s) { s.bodies[0].p_W.y() += 1e-3; },
    [](State& s) { s.bodies[0].L_W.y() += 1e-3; },
    [](State& s) { s.bodies[0].L_P.y() += 1e-3; },
    [](State& s) { s.t += 0.01; },
};

}  // namespace

TEST(ChangedState, IsRefusedWhileItsAnchorsLeadElsewhere) {
  const Simulation sim = tumbling();
  const State state = tumblingAfter(sim);
  ASSERT_LT(state.anchors[0].t, state.t);
  EXPECT_EQ(refusalOf([&] { Simulation(sim.world(), state); }), "");
  for (const auto& change : kChanges) {
    State changed = state;
    change(changed);
    const std::string refusal = "body 'box': its state must be where its anchor leads at t = " +
                                std::string(changed.t == state.t ? "0.07" : "0.08") +
                                " s: clear the anchors and plans of a state that is changed";
    EXPECT_EQ(refusalOf([&] { Simulation(sim.world(), changed); }), refusal);
    Simulation other = sim;
    EXPECT_EQ(refusalOf([&] { other.load(changed); }), refusal);
    EXPECT_EQ(other.time(), 0);
  }
}

TEST(ChangedState, IsGoneOnFromOnceItsAnchorsAreCleared) {
  const Simulation sim = tumbling();
  for (const auto& change : kChanges) {
    State changed = tumblingAfter(sim);
    change(changed);
    changed.anchors.clear();
    changed.plans.clear();
    const Simulation from(sim.world(), changed);
    EXPECT_EQ(from.time(), changed.t);
    EXPECT_EQ(from.body(0).x_W, changed.bodies[0].x_W);
    EXPECT_EQ(from.body(0).q_WP.coeffs(), changed.bodies[0].q_WP.coeffs());
    EXPECT_EQ(from.body(0).p_W, changed.bodies[0].p_W);
  }
}

// what far places and many turns leave in their last digits is no room for changes
TEST(ChangedState, IsRefusedFarFromTheOriginAndAfterManyTurns) {
  Bench bench;
  bench.add(test::principalBody("probe", 2, {1, 2, 2.5}),
            test::tumbling({100, 0, 0}, {0.1, 0.2, 2e4}));
  bench.initial.bodies[0].x_W.x() = 7e6;
  Simulation sim = bench.simulation("auto", 0.01);
  sim.step(20000);
  State moved = sim.state(), turned = sim.state();
  EXPECT_EQ(refusalOf([&] { Simulation(sim.world(), moved); }), "");
  moved.bodies[0].x_W.y() += 5;
  turned.bodies[0].L_P = -turned.bodies[0].L_P;
  for (const State* changed : {&moved, &turned})
    EXPECT_NE(refusalOf([&] { Simulation(sim.world(), *changed); }).find("where its anchor leads"),
              std::string::npos);
}

TEST(ChangedState, HasFixedBodiesWhereTheRunHasThem) {
  Bench bench;
  bench.add(test::principalBody("ground", 2, {1, 2, 2.5}), BodyFrameMotion());
  bench.add(test::principalBody("box", 2, {1, 2, 2.5}), test::tumbling({1, 0, 0}, {0.5, 1, 0.2}));
  bench.fix(0);
  Simulation sim = bench.simulation("auto", 0.01);
  sim.step();
  State changed = sim.state();
  EXPECT_EQ(refusalOf([&] { sim.load(changed); }), "");
  changed.bodies[0].x_W.x() += 5;
  EXPECT_EQ(refusalOf([&] { sim.load(changed); }),
            "body 'ground' is fixed: a state must have it where the run has it");
  EXPECT_EQ(Simulation(sim.world(), changed).body(0).x_W.x(), 5);
}

// the quotient of a time and a step is off by its last digit, which is a larger number there
TEST(ChangedState, IsGoneOnFromAfterTenThousandMillionSteps) {
  Bench bench;
  bench.add(test::principalBody("slow", 1, {1, 2, 2.5}), test::tumbling({0, 0, 0}, {0, 0, 1e-6}));
  for (double n : {13422438872., 10737554832., 1e13}) {
    State late = bench.initial;
    late.t = n * 0.01;
    Bench at = bench;
    at.initial = late;
    Simulation sim = at.simulation("auto", 0.01);
    for (int i = 0; i < 20; ++i) {
      sim.step();
      EXPECT_EQ(refusalOf([&] { Simulation(sim.world(), sim.state()); }), "") << sim.time();
    }
  }
}

// what rounds differently may have written it
TEST(ChangedState, IsTakenWhereLastDigitsDiffer) {
  const Simulation sim = tumbling();
  State state = tumblingAfter(sim);
  state.bodies[0].x_W *= 1 + 1e-12;
  state.bodies[0].L_P *= 1 - 1e-12;
  EXPECT_EQ(refusalOf([&] { Simulation(sim.world(), state); }), "");
}

TEST(StateOfAnotherWorld, IsNotReadBeyondItsEnds) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  for (double x : {0.0, 5.0})
    test::addBall(bench, 0.1, 1, test::motionAt({x, 0, 0.1}), HalfSpace{},
                  test::contactOf(1e5, 1.5, 3, 0.5));
  const World world = bench.simulation("auto", 0.01).world();
  const State state = bench.simulation("auto", 0.01).state();
  State fewer_bodies = state, fewer_laws = state, changed = state;
  fewer_bodies.bodies.pop_back();
  fewer_laws.laws.pop_back();
  changed.changes.resize(2);
  changed.changes[1].absent = true;
  const std::string count = std::to_string(state.laws.size());
  const std::string one_less = std::to_string(state.laws.size() - 1);
  const auto expectRefusal = [&](const State& of, const std::string& refusal) {
    EXPECT_EQ(refusalOf([&] { contactsOf(world, of); }), refusal);
    EXPECT_EQ(refusalOf([&] { lineForcesOf(world, of); }), refusal);
    EXPECT_EQ(refusalOf([&] { mechanicalEnergy(world, of); }), refusal);
    EXPECT_EQ(refusalOf([&] { totalsOf(world, of); }), refusal);
  };
  expectRefusal(state, "");
  expectRefusal(fewer_bodies, "a state must have as many bodies as its world, 2, got 1");
  expectRefusal(fewer_laws, "a state must have as many states of laws as its world, " + count +
                                ", got " + one_less);
  State of_many = changed;
  of_many.changes.resize(9);
  expectRefusal(of_many, "a state must have changes for each body, or for none");
  expectRefusal(changed,
                "the state has changes of bodies which the world lacks: take the world that the "
                "simulation gives, or withChanges");
}

}  // namespace rigid_body_sim
