#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "support/thrown_bodies.hpp"

/// The order of dop853 across touches, releases, slips and grips.
namespace rigid_body_sim {
namespace {

constexpr double kSpan = 0.6;  // [s]

struct BoundedRun {
  std::vector<BodyState> end;
  std::int64_t evaluations;
};

/// Under dop853, which goes by 1e-4 of the tolerance, whatever errors grow to.
BoundedRun runAt(test::Bench bench, double tolerance) {
  bench.world.solver.tolerance = tolerance;
  Simulation sim = bench.simulation("dop853", kSpan);
  sim.step();
  return {sim.state().bodies, sim.evaluations()};
}

double endsApart(const BoundedRun& a, const BoundedRun& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.end.size(); ++i)
    worst = std::max(
        {worst, distanceBetween(a.end[i], b.end[i]), angleBetween(a.end[i].q_WP, b.end[i].q_WP)});
  return worst;
}

// A step that is cut by the eighth root of a bound errs by that bound: where the order is 8, errors
// fall as the bound, and evaluations grow as its eighth root. Both are means of random scenes of
// every kind: the errors of single ones scatter.
TEST(Dop853, IsOfOrderEightAcrossTouchesAndSlips) {
  test::Thrower thrower(58);
  const double tolerances[] = {1e-3, 1e-8};  // bounds of 1e-7 and 1e-12
  double error_decades = 0, growth = 0;
  int count = 0;
  for (int round = 0; round < 3; ++round)
    for (const test::ThrownKind kind : test::kThrownKinds) {
      const test::Bench bench = thrower.next(kind).bench;
      const BoundedRun truth = runAt(bench, 1e-10), coarse = runAt(bench, tolerances[0]),
                       fine = runAt(bench, tolerances[1]);
      error_decades += std::log10(endsApart(coarse, truth) / endsApart(fine, truth));
      growth += std::log10(double(fine.evaluations) / double(coarse.evaluations));
      ++count;
    }
  const double decades = 5;
  EXPECT_GT(error_decades / count, 0.85 * decades);
  EXPECT_LT(growth / count, 1.1 * decades / 8);
  EXPECT_GT(error_decades / growth, 7.5);  // the order itself
}

}  // namespace
}  // namespace rigid_body_sim
