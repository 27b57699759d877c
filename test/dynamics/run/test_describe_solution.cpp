#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/law_benches.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;
using test::principalBody;
using test::tumbling;
using Lines = std::vector<std::string>;

Bench freeBody(const Vector3d& I) {
  Bench bench;
  bench.add(principalBody("wing_nut", 1, I), tumbling({0, 0, 0}, {1, 2, 3}));
  return bench;
}

TEST(DescribeSolution, NamesTheRotorOfAFreeBody) {
  const auto lines = [](const Vector3d& I) {
    return describeSolution(freeBody(I).simulation("auto", 0.01));
  };
  EXPECT_EQ(lines({1, 2, 3}), Lines{"wing_nut: free, asymmetric, exact"});
  EXPECT_EQ(lines({1, 2, 2}), Lines{"wing_nut: free, symmetric, exact"});
  EXPECT_EQ(lines({2, 2, 2}), Lines{"wing_nut: free, spherical, exact"});
}

TEST(DescribeSolution, SaysHowABodyIsSteppedOnceATetherActs) {
  const auto lineOf = [](double length, const char* integrator) {
    Bench bench = freeBody({2, 2, 2});
    bench.world.laws.push_back(std::make_shared<Tether>(Spring::End{kWorld, {0, 0, 1}},
                                                        Spring::End{0, {0, 0, 0}},
                                                        Tether::Constants{100, 1, length}));
    return describeSolution(bench.simulation(integrator, 0.01)).at(0);
  };
  const std::string later = "dop853 by its own error estimates";
  EXPECT_EQ(lineOf(2, "auto"), "wing_nut: tether, spherical, exact; once tether acts, " + later);
  EXPECT_EQ(lineOf(0.5, "auto").find("once"), std::string::npos);
  EXPECT_EQ(lineOf(2, "rk4"), "wing_nut: tether, rk4 in steps of 10 ms");
}

// A difference grows by e^(λt), λ = ω √((I₂ − I₁)(I₃ − I₂)/(I₁ I₃)) = 1.73/s, until it has turned.
TEST(DescribeMagnification, SpeaksOfAFreeRotationNearTheUnstableAxis) {
  const auto after = [](const Vector3d& w, int seconds) {
    Bench bench;
    bench.add(principalBody("wing_nut", 1, {1, 2, 3}), tumbling({0, 0, 0}, w));
    Simulation sim = bench.simulation("auto", 1);
    while (sim.steps() < seconds) sim.step();
    return describeMagnification(sim);
  };
  const Vector3d middle(0, 3, 0), stable(0, 0, 3), tumbles(1, 2, 3);
  EXPECT_EQ(after(middle, 7), "");  // 2e5
  EXPECT_EQ(after(middle, 12),      // 1e9
            "the motion of body 'wing_nut' has magnified differences of its start, rounding among "
            "them, 10^9 times by now: it is exact for this start, but no real body starts "
            "so exactly");
  EXPECT_EQ(after(stable, 1000), "");
  EXPECT_EQ(after(tumbles, 1000), "");
}

// A rod that stands on its pivot: a difference grows by e^(t √(m g l/I)) = e^(3.84 t), until it has
// fallen.
TEST(DescribeInstability, SpeaksOfAPendulumUpsideDown) {
  const auto after = [](double angle, int seconds) {
    Bench bench;
    bench.world.g_W = {0, 0, -9.81};
    const MassProperties rod{1, {0, 0, 0.5}, Vector3d(0.0834, 0.0834, 0.0012).asDiagonal()};
    BodyFrameMotion motion;
    motion.q_WB = rotationExp(Vector3d(angle, 0, 0));
    bench.add(makeBody("rod", rod, {}, Vector3d(0, 0, 0)), motion);
    Simulation sim = bench.simulation("auto", 0.5);
    const State start = sim.state();
    while (sim.time() < seconds) sim.step();
    EXPECT_EQ(sim.evaluations(), 0);
    return describeInstability(sim, start);
  };
  EXPECT_EQ(after(0, 4), "");  // 5e6
  // e^(3.84 * 6) = 1.0e10, half of which grows
  EXPECT_EQ(after(0, 6),
            "the motion of body 'rod' has magnified differences of its start, rounding among them, "
            "10^10 times by now: it is that of a start which differs in its last digits, and no "
            "real body starts so exactly");
  EXPECT_EQ(after(M_PI, 40), "");  // hanging
  EXPECT_EQ(after(1, 40), "");     // swinging
}

TEST(DescribeSolution, SaysOnceWhatIsTheSameOfManyNeighbours) {
  Bench bench;
  for (int i = 0; i < 40; ++i)
    bench.add(principalBody("b" + std::to_string(i), 1, {1, 1, 1}), BodyFrameMotion());
  EXPECT_EQ(describeSolution(bench.simulation("auto", 0.01)).size(), 40);
  bench.add(principalBody("other", 1, {1, 2, 3}), BodyFrameMotion());
  bench.add(principalBody("last", 1, {1, 1, 1}), BodyFrameMotion());
  EXPECT_EQ(describeSolution(bench.simulation("auto", 0.01)),
            (Lines{"b0 to b39 (40 bodies): free, spherical, exact",
                   "other: free, asymmetric, exact", "last: free, spherical, exact"}));
}

TEST(DescribeSolution, SaysWhatActsAndHowItIsSolved) {
  EXPECT_EQ(describeSolution(test::pushedBox(kWorld, 0).simulation("auto", 0.01)),
            Lines{"box: gravity, wrenches, Taylor"});
  Bench rocket = freeBody({1, 2, 3});
  rocket.world.wrenches.emplace_back().force = {0, 0, 1};  // at the centre of mass
  EXPECT_EQ(describeSolution(rocket.simulation("auto", 0.01)),
            Lines{"wing_nut: wrenches, asymmetric, exact"});
  Bench bench = test::springPair(1);
  bench.addDrag(1, {0.1, 0, 0});
  Body table = principalBody("table", 1, {1, 1, 1});
  table.fixed = true;
  bench.add(table, BodyFrameMotion());
  bench.add(principalBody("loose", 1, {1, 2, 3}), BodyFrameMotion());
  EXPECT_EQ(
      describeSolution(bench.simulation("rk4", 0.002)),
      (Lines{"upper: spring, rk4 in steps of 2 ms", "lower: spring, drag, rk4 in steps of 2 ms",
             "table: fixed", "loose: free, rk4 in steps of 2 ms"}));
  EXPECT_EQ(describeSolution(test::satellite().simulation("strang", 0.001)),
            Lines{"satellite: central gravity, strang in steps of 1 ms"});
}

TEST(DescribeSolution, NamesTheIntegratorThatAutoChose) {
  Bench bench = test::springPair(1);
  bench.world.solver.horizon = 1;
  const Simulation sim = bench.simulation("auto", 0.5);
  const MotionPlan plan = sim.plans()[0];
  ASSERT_GT(plan.substeps, 1);
  const Lines lines = describeSolution(sim);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].find("upper: spring, " + plan.integrator + " in substeps of "), 0u)
      << lines[0];
  EXPECT_NE(lines[0].find("(" + std::to_string(plan.substeps) + " per step)"),
            Lines::value_type::npos)
      << lines[0];
}

TEST(DescribeSolution, OwnsUpWhereNothingHoldsTheTolerance) {
  Bench bench = test::springPair(1);
  bench.world.solver.horizon = 1;
  bench.world.solver.tolerance = 1e-30;
  const Lines lines = describeSolution(bench.simulation("auto", 0.01));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NE(lines[2].find("upper and 1 with it: no integrator was found to hold tolerance 1e-30"),
            std::string::npos)
      << lines[2];
}

// Half of the tolerance may be error; what is lost with less is lost for rounding.
TEST(DescribeSolution, SaysWhetherErrorOrRoundingTakesTheTolerance) {
  Bench bench = test::springPair(1);
  bench.world.solver.integrator = "auto";
  State state = bench.simulation("auto", 0.5).state();
  ASSERT_EQ(state.plans.size(), 1U);
  state.plans[0].holds = false;
  const auto lineAt = [&](double error) {
    state.plans[0].error = error;
    return describeSolution(Simulation(bench.world, state)).back();
  };
  EXPECT_NE(lineAt(0.3).find("; rounding alone makes 0.3 times that, where"), std::string::npos);
  EXPECT_NE(lineAt(0.7).find("; the least error found was 0.7 times that, where"),
            std::string::npos);
}

TEST(DescribeSubsteps, SaysHowFarStepsWereDivided) {
  Simulation slow = freeBody({1, 2, 3}).simulation("strang", 0.01);
  slow.step();
  EXPECT_EQ(describeSubsteps(slow), "");
  Simulation fast = freeBody({1, 2, 3}).simulation("strang", 1);
  fast.step();
  const std::string told = describeSubsteps(fast);
  EXPECT_NE(told.find("into up to 5 substeps"), std::string::npos) << told;
  EXPECT_NE(told.find("keeps strang stable, not accurate"), std::string::npos) << told;
}

}  // namespace
}  // namespace rigid_body_sim
