#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>

#include "dynamics/run/run.hpp"
#include "support/contact_benches.hpp"
#include "support/reference_bench.hpp"
#include "support/same_state.hpp"

/// A tether that becomes taut and slack many times magnifies errors: what auto holds there, and
/// what it says.
namespace rigid_body_sim {
namespace {

using reference::Motions;
using reference::Real;
using reference::Vector;
using test::Bench;

const Vector3d kFlungPoint_B(-0.031, -0.011, -0.227), kFlungAnchor_W(0.71, -0.4, 0.4);  // [m]
constexpr double kFlungStiffness = 517.5, kFlungLength = 1;
constexpr double kFlungEnd = 2, kFlungStep = 0.01;  // [s]

Body flungBody() { return test::principalBody("box", 0.89, {0.0464, 0.0421, 0.00727}); }

Vector3d flungPointP() { return rotateBack(flungBody().q_BP, kFlungPoint_B); }

/// A box that is thrown about by its tether, which becomes taut or slack every tenth of a second.
/// An error of its start is magnified a million times in two seconds.
Bench flungBox(double tolerance, bool starts_slack) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  BodyFrameMotion motion;
  motion.x_W = {-0.76, -0.72, -0.74};
  motion.q_WB = Quaterniond(0.8919077, 0.3534726, 0.0792735, 0.2707237).normalized();
  motion.v_W = {-0.03, 1.44, -0.47};
  motion.w_W = {-1.79, -4.79, -0.78};
  if (starts_slack) {
    motion.x_W = {0.4326421, -0.4501137, 0.2147431};
    motion.q_WB = Quaterniond(0.1161945, -0.232849, 0.2562564, -0.9308736).normalized();
    motion.v_W = {14.5200380, 2.9411525, 11.3854821};
    motion.w_W = {51.0396112, -61.3519988, -22.0074145};
  }
  bench.add(flungBody(), motion);
  bench.world.laws.push_back(
      std::make_shared<Tether>(Spring::End{0, flungPointP()}, Spring::End{kWorld, kFlungAnchor_W},
                               Tether::Constants{kFlungStiffness, 0, kFlungLength}));
  bench.world.solver.tolerance = tolerance;
  bench.world.solver.tolerance_stated = true;
  bench.world.solver.horizon = kFlungEnd;
  return bench;
}

/// [m] By how much the line is longer than the tether.
Real excessLength(const Motions& m) {
  const Vector end_W = m[0].x + m[0].R() * flungPointP().cast<Real>();
  return (end_W - kFlungAnchor_W.cast<Real>()).norm() - Real(kFlungLength);
}

/// Springs and flights of the reference in turn, from one zero of the excess to the next, which is
/// found by bisection.
class TetherReference {
 public:
  explicit TetherReference(const Bench& bench)
      : bench_(bench),
        spring_(reference::spring({0, flungPointP()}, {kWorld, kFlungAnchor_W},
                                  {kFlungStiffness, 0, kFlungLength})),
        motions_{reference::toMotion(bench.world.bodies[0], bench.initial.bodies[0])},
        is_taut_(excessLength(motions_) > 0) {}

  const Motions& motions() const { return motions_; }
  int changes() const { return changes_; }

  void goOn(Real duration) {
    constexpr Real kChunk = 1e-3L;  // the shortest pull lasts 5 ms
    for (Real done = 0; done < duration;) {
      Real step = std::min(kChunk, duration - done);
      Motions next = after(step);
      const bool changes = (excessLength(next) > 0) != is_taut_;
      if (changes) {
        step = firstChange(step);
        next = after(step);
      }
      motions_ = next;
      done += step;
      if (changes) is_taut_ = !is_taut_;
      changes_ += changes;
    }
  }

 private:
  Motions after(Real duration) const {
    const auto wrenches = [this](Real, const Motions& m) {
      reference::Loads loads(1);
      const std::vector<Body>& bodies = bench_.world.bodies;
      loads[0].f_W = Real(bodies[0].mass) * bench_.world.g_W.cast<Real>();
      if (is_taut_) spring_(bodies, m, loads);
      return loads;
    };
    return reference::advance(bench_.world.bodies, wrenches, motions_, 0, duration, duration);
  }

  Real firstChange(Real after_it) const {
    Real before = 0;
    for (int i = 0; i < 64; ++i) {
      const Real middle = (before + after_it) / 2;
      ((excessLength(after(middle)) > 0) == is_taut_ ? before : after_it) = middle;
    }
    return after_it;
  }

  const Bench& bench_;
  reference::Law spring_;
  Motions motions_;
  bool is_taut_;
  int changes_ = 0;
};

/// Steps through all runs beside the reference; returns how often the tether has become taut or
/// slack.
int expectHeldBeside(std::vector<Simulation>& sims, const Bench& bench, const std::string& what) {
  TetherReference truth(bench);
  for (int k = 1; k * kFlungStep < kFlungEnd + kFlungStep / 2; ++k) {
    truth.goOn(Real(kFlungStep));
    for (Simulation& sim : sims) {
      sim.step();
      const double tolerance = sim.world().solver.tolerance;
      EXPECT_LT(test::motionErrors(sim.state(), truth.motions()).attitude, tolerance)
          << what << ", tolerance " << tolerance << ", t = " << sim.time();
    }
  }
  return truth.changes();
}

}  // namespace

// The bounds of single steps that would do without magnification miss it by a hundred times.
TEST(TetherPromise, IsKeptWhereSuddenPullsMagnifyErrors) {
  for (bool starts_slack : {false, true}) {
    std::vector<Simulation> sims;
    for (double tolerance : {1e-2, 1e-3, 1e-4}) {
      sims.push_back(flungBox(tolerance, starts_slack).simulation("auto", kFlungStep));
      EXPECT_TRUE(std::isinf(sims.back().contactTrial().lost_at)) << tolerance;
      EXPECT_LT(sims.back().contactTrial().step_bound, 0.1 * contactStepBound(tolerance));
      EXPECT_EQ(sims.back().plans()[0].by_estimates, !starts_slack);
      EXPECT_NE(describeSolution(sims.back()).back().find("tether: errors of a step are kept"),
                std::string::npos);
    }
    EXPECT_GT(expectHeldBeside(sims, flungBox(1, starts_slack), starts_slack ? "slack" : "taut"),
              10);
  }
}

// What is not in contact must be tried as it is without.
TEST(TetherPromise, IsKeptInASceneWithContact) {
  Bench bench = flungBox(1e-4, false);
  HalfSpace far_below;
  far_below.origin_W = {0, 0, -1e3};
  bench.world.laws.push_back(contactWithHalfSpace(bench.world.bodies, 0, test::ballShape(0.1),
                                                  far_below, test::contactOf(1e6, 1.5, 0.2, 0)));
  std::vector<Simulation> sims{bench.simulation("auto", kFlungStep)};
  EXPECT_LT(sims[0].contactTrial().step_bound, 0.1 * contactStepBound(1e-4));
  expectHeldBeside(sims, bench, "above a ground");
}

TEST(TetherPromise, IsSaidNotToBeCertainWhereNoStepHoldsIt) {
  const Simulation sim = flungBox(1e-8, false).simulation("auto", kFlungStep);
  EXPECT_LT(sim.contactTrial().lost_at, kFlungEnd);
  EXPECT_NE(describeSolution(sim).back().find("tolerance 1e-08 is not certain to be held from"),
            std::string::npos)
      << describeSolution(sim).back();
}

TEST(TetherPromise, GoesOnFromAStateWithTheSameBits) {
  const Simulation sim = flungBox(1e-4, false).simulation("auto", kFlungStep);
  EXPECT_FALSE(Simulation(sim.world(), sim.state()).contactTrial().is_made);
  test::expectToGoOnTheSame(sim, {20, 30, 50, 40});
}

/// [rad] How far a run by estimates, and the one beside it, are from the reference, and from each
/// other, a quarter of a second on.
struct ErrorsBeside {
  double run, beside, apart;
};
ErrorsBeside errorsBeside(double tolerance, double step) {
  Bench bench = flungBox(1e-2, false);
  bench.world.solver.integrator = "auto";
  bench.world.solver.time_step = step;
  State start = Simulation(bench.world, bench.initial).state();
  EXPECT_TRUE(start.plans[0].by_estimates);
  start.contact_bound = contactStepBound(tolerance);
  bench.world.solver.tolerance = tolerance;
  rigid_body_sim::Run run(std::make_shared<const World>(bench.world),
                          std::make_shared<const State>(start));
  rigid_body_sim::Run beside = run.atTighterBounds();
  while (run.now().time < 0.25 - 1e-9) {
    run.step();
    beside.step();
  }
  TetherReference truth(bench);
  truth.goOn(Real(run.now().time));
  return {test::motionErrors(run.state(), truth.motions()).attitude,
          test::motionErrors(beside.state(), truth.motions()).attitude,
          angleBetween(run.body(0).q_WP, beside.body(0).q_WP)};
}

// Steps that err by less than they may are not divided: looser bounds would change none of them.
// Steps that are divided by estimates err by less where the bounds are tighter.
TEST(TetherPromise, IsTriedBesideARunThatErrsByFarLess) {
  for (const auto& [tolerance, step] : {std::pair(1e-2, 0.01), std::pair(1e-6, 0.05)}) {
    const ErrorsBeside errors = errorsBeside(tolerance, step);
    EXPECT_LT(errors.beside, errors.run / 50) << tolerance;
  }
}

// At the least bound, substeps follow from what swings fastest alone.
TEST(TetherPromise, IsTriedBesideAnotherRunAtTheLeastBound) {
  const ErrorsBeside errors = errorsBeside(1e-11, 0.125);
  EXPECT_GT(errors.apart, 1e-15);  // of the same bits it is below a rounding
}

// A pull magnifies what the flight before it errs by.
TEST(TetherPromise, IsNotSpoiltByFlightsBetweenPulls) {
  std::vector<State> ends;
  for (double tolerance : {1e-2, 1e-12}) {
    Bench bench = flungBox(tolerance, true);
    PointWrench push;
    push.force = {0, 1, 2};
    push.point = {0, 0, 0.3};
    push.axes = kOwnBody;
    bench.world.wrenches = {push};
    Simulation sim = bench.simulation("auto", kFlungStep);
    sim.step();
    ASSERT_TRUE(sim.plans()[0].integrator.empty());
    ends.push_back(sim.state());
  }
  test::expectSameBodyState(ends[0].bodies[0], ends[1].bodies[0]);
}

// Where a tether stays taut, what was tried at the start is what comes, and it is cheaper.
TEST(TetherPromise, LeavesATautTetherTheIntegratorThatWasTried) {
  Bench bench = flungBox(1e-4, false);
  BodyFrameMotion hanging;
  hanging.q_WB = Quaterniond(0, 1, 0, 0);  // the tether's point above the centre of mass
  hanging.x_W = {0.6, -0.4, -0.84};
  bench.initial.bodies[0] = toBodyState(bench.world.bodies[0], hanging);
  const Simulation sim = bench.simulation("auto", kFlungStep);
  EXPECT_FALSE(sim.contactTrial().regroups);
  EXPECT_EQ(sim.contactTrial().tried_until, kFlungEnd);
  EXPECT_FALSE(sim.plans()[0].by_estimates);
}

// Which is done for a stated tolerance alone, as with contact.
TEST(TetherPromise, IsNotTriedWhereNoToleranceIsStated) {
  Bench bench = flungBox(1e-4, false);
  bench.world.solver.tolerance_stated = false;
  EXPECT_FALSE(bench.simulation("auto", kFlungStep).contactTrial().is_made);
}

}  // namespace rigid_body_sim
