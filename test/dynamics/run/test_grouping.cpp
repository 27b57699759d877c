#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "support/contact_benches.hpp"
#include "support/law_benches.hpp"
#include "support/worlds.hpp"

/// Which bodies are advanced together, and when that changes.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::principalBody;
using test::tumbling;

Bench fourBodies() {
  Bench bench;
  for (const char* name : {"a", "b", "c", "d"})
    bench.add(principalBody(name, 2, {1, 2, 2.5}), tumbling({0, 0, 0}, {0.5, 1, 0.2}));
  return bench;
}

/// A push on one body in the axes of another.
PointWrench inAxesOf(std::size_t axes, std::size_t body, double start, double end) {
  PointWrench push;
  push.body = body;
  push.axes = axes;
  push.force = {1, 2, 3};
  push.start = start;
  push.end = end;
  return push;
}

std::vector<std::string> integrators(const Simulation& sim) {
  std::vector<std::string> of_body(sim.world().bodies.size());
  for (const MotionPlan& plan : sim.plans())
    for (std::size_t body : plan.bodies) of_body[body] = plan.integrator;
  return of_body;
}

void expectSameBits(const BodyState& x, const BodyState& y) {
  EXPECT_EQ(x.x_W, y.x_W);
  EXPECT_EQ(x.x_low_W, y.x_low_W);
  EXPECT_EQ(x.q_WP.coeffs(), y.q_WP.coeffs());
  EXPECT_EQ(x.p_W, y.p_W);
  EXPECT_EQ(x.L_W, y.L_W);
  EXPECT_EQ(x.L_P, y.L_P);
}

TEST(Grouping, LinksBodiesOnlyWhileAWrenchDoes) {
  Bench bench = fourBodies();
  bench.world.wrenches = {inAxesOf(1, 0, 0.105, 0.2)};
  Simulation sim = bench.simulation("auto", 0.01);
  const std::vector<std::string> solved(4);
  EXPECT_EQ(integrators(sim), solved);
  while (sim.steps() < 15) sim.step();
  EXPECT_EQ(integrators(sim), (std::vector<std::string>{"dop853", "dop853", "", ""}));
  while (sim.steps() < 20) sim.step();
  EXPECT_EQ(integrators(sim), solved);
}

TEST(Grouping, GivesBodiesThatWereLinkedTheBitsOfThoseThatWereNot) {
  Bench bench = fourBodies();
  bench.world.wrenches = {inAxesOf(1, 0, 0, 0.1)};
  Simulation once = bench.simulation("auto", 0.01), again = once;
  for (int i = 0; i < 20; ++i) {
    once.step();
    again.step();
  }
  // a link between others is none of their business
  again.applyWrench("", inAxesOf(3, 2, 0.2, 1));
  for (int i = 0; i < 50; ++i) {
    once.step();
    again.step();
  }
  for (std::size_t body : {0, 1}) expectSameBits(once.body(body), again.body(body));
}

TEST(Grouping, KeepsTheOrderOfAWrenchInTheAxesOfAnotherBodyThatStartsWithinAStep) {
  std::vector<double> errors;
  Bench bench = fourBodies();
  bench.world.wrenches = {inAxesOf(1, 0, 0.1234567, 0.87654321)};
  const Vector3d truth = bench.run("dop853", 1, 1000).bodies[0].x_W;
  for (int steps : {40, 80})
    errors.push_back((bench.run("rk4", 1, steps).bodies[0].x_W - truth).norm());
  EXPECT_LT(errors[0], 1e-6);
  EXPECT_GT(errors[0] / errors[1], 16 / 1.5);
  EXPECT_LT((bench.run("auto", 1, 7).bodies[0].x_W - truth).norm(), 1e-9);
}

TEST(Grouping, SamplesPastAnInstantAtWhichBodiesAreLinked) {
  Bench bench = fourBodies();
  bench.world.wrenches = {inAxesOf(1, 0, 0.31, 5)};
  Simulation coarse = bench.simulation("auto", 1), fine = bench.simulation("auto", 0.01);
  while (fine.steps() < 70) fine.step();
  const State sampled = coarse.sample(0.7);
  EXPECT_LT((sampled.bodies[0].x_W - fine.body(0).x_W).norm(), 1e-9);
  coarse.step();
  EXPECT_EQ(coarse.steps(), 1);
}

// A push of 37 N m in the axes of another body at rest turns a box by many radians within the step.
TEST(Grouping, DividesStepsForAWrenchInTheAxesOfAnotherBody) {
  for (std::size_t axes : {kWorld, std::size_t{1}}) {
    Bench bench;
    for (const char* name : {"box", "still"})
      bench.add(principalBody(name, 2, {1, 2, 2.5}), BodyFrameMotion());
    PointWrench push;
    push.axes = axes;
    push.torque = {37, 0, 0};
    bench.world.wrenches = {push};
    Simulation sim = bench.simulation("rk4", 1);
    sim.step();
    EXPECT_EQ(sim.maxSubsteps(), 93) << axes;  // 37 rad/s over 1 s, at most 0.4 rad each
  }
}

TEST(PointWrench, ActsOnItsOwnBodyUnlessItSaysOtherwise) {
  Bench bench = fourBodies();
  PointWrench push;
  push.body = 1;
  push.force = {1, 0, 0};
  push.point = {0, 0.5, 0};
  bench.world.wrenches = {push};
  const Simulation sim = bench.simulation("auto", 0.01);
  EXPECT_EQ(sim.plans().size(), 4u);
  EXPECT_EQ(sim.appliedWrench(1).tau_W + sim.appliedWrench(1).tau_P,
            (rotate(sim.body(1).q_WP, push.point).cross(push.force)));
}

// b diverges in the step in which a's wrench starts.
TEST(Simulation, LeavesOtherBodiesTheirBitsWhereAStepIsTakenBack) {
  Bench bench = fourBodies();
  bench.world.bodies[1] = principalBody("b", 1e-300, {1e-300, 1e-300, 1e-300});
  bench.initial.bodies[1] = toBodyState(bench.world.bodies[1], BodyFrameMotion());
  PointWrench push, blow;
  push.force = {1, 2, 3};
  push.point = {0.1, 0.2, 0.3};
  push.start = 0.105;
  blow.body = 1;
  blow.force = {1e300, 0, 0};
  blow.start = 0.101;
  Simulation disturbed = bench.simulation("auto", 0.01);
  disturbed.applyWrench("", push);
  Simulation undisturbed = disturbed;
  disturbed.applyWrench("blow", blow);
  while (undisturbed.steps() < 10) {
    undisturbed.step();
    disturbed.step();
  }
  EXPECT_THROW(disturbed.step(), SimulationDiverged);
  disturbed.clearWrenches(1);
  for (int i = 0; i < 30; ++i) {
    undisturbed.step();
    disturbed.step();
  }
  expectSameBits(undisturbed.body(0), disturbed.body(0));
}

TEST(Simulation, CountsWhatAStepThatIsTakenBackEvaluatedOnce) {
  Bench bench = fourBodies();
  bench.world.bodies[1] = principalBody("b", 1e-300, {1e-300, 1e-300, 1e-300});
  bench.initial.bodies[1] = toBodyState(bench.world.bodies[1], BodyFrameMotion());
  bench.world.wrenches = {inAxesOf(3, 2, 0.1025, 1)};
  PointWrench blow;
  blow.body = 1;
  blow.force = {1e300, 0, 0};
  Simulation sim = bench.simulation("rk4", 0.01);
  while (sim.steps() < 10) sim.step();
  const std::int64_t before = sim.evaluations();
  sim.applyWrench("blow", blow);
  EXPECT_THROW(sim.step(), SimulationDiverged);
  EXPECT_LE(sim.evaluations() - before, before / 10);  // of ten steps alike
}

TEST(Simulation, GoesOnFromAStateWithTheBitsOfTheRunThatItIsFrom) {
  std::vector<Bench> benches{fourBodies(), test::springPair(1), test::satellite(),
                             test::thrown({0.1, 0.2, 0.1}), test::pushedBox(kWorld, 0)};
  benches[0].world.wrenches = {inAxesOf(1, 0, 0.2, 0.41)};
  benches[4].world.wrenches[0].start = 0.123;
  benches[4].world.wrenches[0].end = 0.777;
  for (std::size_t k = 0; k < benches.size(); ++k) {
    benches[k].world.solver.horizon = 1;
    for (const char* name : {"auto", "rk4", "dop853"}) {
      Simulation whole = benches[k].simulation(name, 0.01);
      while (whole.steps() < 37) whole.step();
      Simulation rest(whole.world(), whole.state());
      EXPECT_EQ(rest.time(), whole.time());
      EXPECT_EQ(rest.steps(), 37);
      for (int i = 0; i < 60; ++i) {
        whole.step();
        rest.step();
      }
      for (std::size_t body = 0; body < whole.world().bodies.size(); ++body) {
        SCOPED_TRACE(std::to_string(k) + name);
        expectSameBits(whole.body(body), rest.body(body));
      }
    }
  }
}

TEST(Simulation, RefusesWorldsAndStatesThatBreakARule) {
  const auto fault = [](const auto& change) -> std::string {
    Bench bench = fourBodies();
    bench.world.solver.time_step = 0.01;
    change(bench);
    try {
      Simulation(bench.world, bench.initial);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "taken";
  };
  EXPECT_EQ(fault([](Bench&) {}), "taken");
  EXPECT_EQ(fault([](Bench& b) { b.world.solver.time_step = -0.01; }),
            "time_step must be > 0 s, got -0.01");
  EXPECT_EQ(fault([](Bench& b) { b.initial.bodies.pop_back(); }),
            "a state must have as many bodies as its world, 4, got 3");
  EXPECT_EQ(fault([](Bench& b) { b.initial.bodies[2].q_WP.coeffs() *= 2; }),
            "body 'c': attitude must be a unit quaternion: norm 1, got 2");
  EXPECT_EQ(fault([](Bench& b) { b.initial.bodies[1].p_W.x() = NAN; }),
            "body 'b': momenta must be finite");
  EXPECT_EQ(fault([](Bench& b) { b.initial.t = 0.015; }),
            "time must be a multiple of time_step, from 0 to 2^53 of them, got 0.015");
  EXPECT_EQ(fault([](Bench& b) { b.world.wrenches = {inAxesOf(7, 0, 0, 1)}; }),
            "wrench on body 'a': no body has the index 7");
  EXPECT_EQ(fault([](Bench& b) {
              b.addSpring({0, {}}, {9, {}}, {1, 0, 0});
            }),
            "law 'spring': no body has the index 9");
  EXPECT_EQ(fault([](Bench& b) {
              b.addDrag(0, {1, 0, 0});
              b.addDrag(0, {2, 0, 0});
            }),
            "law 'drag': body 'a' has one already");
  EXPECT_EQ(fault([](Bench& b) { b.world.laws.push_back(nullptr); }), "a law must not be null");
  const auto faultOfFixed = [&](const auto& change) {
    return fault([&](Bench& b) {
      b.fix(3);
      change(b.initial.bodies[3]);
    });
  };
  EXPECT_EQ(faultOfFixed([](BodyState&) {}), "taken");
  EXPECT_EQ(faultOfFixed([](BodyState& s) { s.L_P.z() = 2; }),
            "body 'd' is fixed, its momentum and angular momentum must be zero");
  EXPECT_EQ(faultOfFixed([](BodyState& s) { s.x_W.y() = NAN; }),
            "body 'd': position must be finite");
  EXPECT_EQ(faultOfFixed([](BodyState& s) { s.q_WP.coeffs() *= 2; }),
            "body 'd': attitude must be a unit quaternion: norm 1, got 2");
}

// n bodies and n wrenches in time that grows as n: a million pairs would not end.
TEST(DescribeSolution, LooksAtEachWrenchOnce) {
  Bench bench;
  constexpr std::size_t kBodies = 20000;
  for (std::size_t i = 0; i < kBodies; ++i) {
    bench.add(principalBody("b", 1, {1, 1, 1}), BodyFrameMotion());
    PointWrench push;
    push.body = i;
    push.force = {1, 0, 0};
    bench.world.wrenches.push_back(push);
  }
  EXPECT_EQ(describeSolution(bench.simulation("auto", 0.01)).size(), 1);
}

TEST(Grouping, EndsWhereAWrenchThatLinksGivesWayToOneThatDoesNot) {
  Simulation sim = fourBodies().simulation("auto", 0.01);
  sim.applyWrench("push", inAxesOf(1, 0, 0, 9));
  sim.step();
  EXPECT_EQ(sim.plans().size(), 3u);
  sim.applyWrench("push", inAxesOf(kWorld, 0, 0, 9));
  EXPECT_EQ(sim.plans().size(), 4u);
}

// In the axes of a body that stands still, on one that slides without friction.
TEST(Grouping, LinksABodyInContactWithinAStep) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, test::motionAt({0, 0, 0.1}), HalfSpace{},
               test::contactOf(1e5, 1.5, 3, 0));
  bench.add(principalBody("other", 2, {1, 2, 2.5}), test::motionAt({9, 0, 0}));
  PointWrench push = inAxesOf(1, 0, 0.105, 0.205);
  push.force = {3, 0, 0};
  bench.world.wrenches.push_back(push);
  Simulation sim = bench.simulation("auto", 0.01);
  while (sim.steps() < 30) sim.step();
  EXPECT_NEAR(sim.body(0).p_W.x(), 0.3, 1e-6);
}

}  // namespace
}  // namespace rigid_body_sim
