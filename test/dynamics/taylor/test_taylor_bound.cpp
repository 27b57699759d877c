#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/taylor/taylor_recursion.hpp"
#include "support/taylor_cases.hpp"

namespace rigid_body_sim {
namespace {

int segmentsOf(const Body& body, const HeldWrench& wrench, BodyState state, double duration,
               const ErrorBound& bound) {
  for (int count = 1;; ++count) {
    const TaylorSegment segment(body, wrench, kGravity, state, duration, bound);
    if (!(segment.validFor() < duration)) return count;
    state = segment.at(segment.validFor());
    duration -= segment.validFor();
  }
}

}  // namespace

// Random bodies under one to three wrenches of every kind, turning through some 5 to 50 rad.
TEST(TaylorSegment, KeepsToABoundOnTheError) {
  constexpr double kDuration = 2;
  Draw draw(23);
  int loose = 0, tight = 0;
  for (int i = 0; i < 60; ++i) {
    const Body body = draw.box(i % 4);
    const BodyState start = draw.state(body, 1);
    std::vector<PointWrench> applied;
    for (int j = 0; j < 1 + i % 3; ++j)
      applied.push_back(randomWrench(draw, (i / 3 + j) % 5, body, 1));
    const HeldWrench wrench = held(applied);
    BodyStateT<Real> precise;
    precise.q_WP = start.q_WP.cast<Real>().normalized();
    precise.x_W = start.x_W.cast<Real>();
    precise.p_W = start.p_W.cast<Real>();
    precise.L_P = start.L_P.cast<Real>();
    precise.L_W = start.L_W.cast<Real>();
    precise = advanceTaylor<Real>(body, wrench, kGravity, precise, kDuration);
    for (double attitude : {1e-2, 1e-4, 1e-6, 1e-9}) {
      const BodyState end =
          advanceTaylor(body, wrench, kGravity, start, kDuration, {attitude, kDuration});
      EXPECT_LE(double(angleBetween<Real>(end.q_WP.cast<Real>(), precise.q_WP)), attitude) << i;
    }
    loose += segmentsOf(body, wrench, start, kDuration, {1e-2, kDuration});
    tight += segmentsOf(body, wrench, start, kDuration, {});
  }
  EXPECT_LT(loose, 0.75 * tight);
}

// The error told is the difference from the motion solved to rounding.
TEST(Simulation, TellsTheErrorOfAMotionSolvedToAStatedTolerance) {
  World world;
  world.bodies = {bodyOf(2, 2.0 / 12 * Vector3d(0.3125, 1.0625, 1.25))};
  PointWrench push;
  push.force = Vector3d(1, 2, 12);
  push.point = Vector3d(0.3, -0.1, 0.05);
  world.wrenches = {push};
  world.solver.time_step = 0.5;
  State initial;
  initial.bodies.resize(1);
  Simulation precise(world, initial);
  world.solver.tolerance = 1e-3;
  world.solver.tolerance_stated = true;
  Simulation simulation(world, initial);
  simulation.trackError();
  double worst = 0;
  while (simulation.steps() < 20) {
    for (Simulation* run : {&simulation, &precise}) run->step();
    worst = std::max(worst, angleBetween(simulation.body(0).q_WP, precise.body(0).q_WP));
  }
  EXPECT_GT(worst, 1e-7);
  EXPECT_LE(worst, 1e-3);
  EXPECT_NEAR(simulation.errorEstimate().attitude, worst, 1e-3 * worst);
}

TEST(TaylorRecursion, GivesTheSameBitsOnWideAndNarrowLanes) {
  Draw draw(3);
  const auto fill = [&](double(&lanes)[4]) {
    for (double& lane : lanes) lane = draw.uniform(-1, 1);
  };
  for (int i = 0; i < 100; ++i) {
    TaylorEquations<double> equations;
    fill(equations.gyroscopic);
    fill(equations.steady);
    for (auto& column : equations.turning) fill(column);
    TaylorSeries<double> wide, narrow;
    fill(wide.w[0]);
    fill(wide.q[0]);
    narrow = wide;
    const std::size_t degree = 7 + static_cast<std::size_t>(i) % 14;
    expandTaylor(equations, i % 3 > 0, degree, wide);
    expandTaylorNarrow(equations, i % 3 > 0, degree, narrow);
    for (std::size_t k = 0; k <= degree; ++k) {
      for (int lane = 0; lane < 4; ++lane) {
        EXPECT_EQ(wide.w[k][lane], narrow.w[k][lane]);
        EXPECT_EQ(wide.q[k][lane], narrow.q[k][lane]);
        if (k == 0 || i % 3 == 0) continue;
        EXPECT_EQ(wide.squares[k][lane], narrow.squares[k][lane]);
        EXPECT_EQ(wide.crosses[k][lane], narrow.crosses[k][lane]);
        EXPECT_EQ(wide.turns[k][lane], narrow.turns[k][lane]);
      }
    }
  }
}

TEST(TaylorRecursion, GivesTheSameNumbersWithoutMomentsThatAreZero) {
  Draw draw(4);
  for (int i = 0; i < 20; ++i) {
    TaylorEquations<double> equations{};
    TaylorSeries<double> with, without;
    for (auto* lanes : {&equations.gyroscopic, &equations.steady, &with.w[0], &with.q[0]})
      for (double& lane : *lanes) lane = draw.uniform(-1, 1);
    without = with;
    const std::size_t degree = 7 + static_cast<std::size_t>(i) % 14;
    equations.turns = true;
    expandTaylor(equations, true, degree, with);
    equations.turns = false;
    expandTaylor(equations, true, degree, without);
    for (std::size_t k = 1; k <= degree; ++k)
      for (int lane = 0; lane < 4; ++lane) {
        EXPECT_EQ(with.w[k][lane], without.w[k][lane]);
        EXPECT_EQ(with.q[k][lane], without.q[k][lane]);
        EXPECT_EQ(with.turns[k][lane], without.turns[k][lane]);
      }
  }
}

}  // namespace rigid_body_sim
