#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "support/ladder.hpp"
#include "support/law_benches.hpp"
#include "support/method_cases.hpp"

namespace rigid_body_sim {
namespace {

using namespace test;  // cases and benches

/// Sizes of what is left over, the greatest of a run.
struct Leftover {
  double energy = 0, momentum = 0, angular_momentum = 0;

  void include(const Totals& balance) {
    energy = std::max(energy, std::abs(balance.energy));
    momentum = std::max(momentum, balance.momentum.norm());
    angular_momentum = std::max(angular_momentum, balance.angular_momentum.norm());
  }
};

Simulation tracked(const Bench& bench, const std::string& integrator, double step) {
  Simulation sim = bench.simulation(integrator, step);
  sim.trackBalance();
  return sim;
}

void run(Simulation& sim, int steps) {
  for (int i = 0; i < steps; ++i) sim.step();
}

/// [J] the simulation's energy, kinetic and of gravity and laws.
double energyOf(const Simulation& sim) { return mechanicalEnergy(sim.world(), sim.state()); }

class BalanceOfEveryMethod : public testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Catalogue, BalanceOfEveryMethod, testing::ValuesIn(catalogue()),
                         [](const auto& method) { return std::string(method.param.name); });

// Energies are up to 400 J, momenta 40 N s, angular momenta 400 N m s: ten roundings of each.
// Events lie inside steps, and the longest step spans many series. The integrator `taylor` begins
// anew at every step, and its roundings add up as they come.
TEST(Balance, ClosesToRoundingWhereTheMotionIsSolved) {
  for (const Case& c : allCases()) {
    if (needsOf(c) != 0) continue;
    for (const char* integrator : {"auto", "taylor"})
      for (int steps : {1, 7, 300}) {
        Simulation sim = tracked(c.bench, integrator, 2.0 / steps);
        run(sim, steps);
        Leftover left;
        left.include(sim.balance());
        const double more = integrator == std::string("auto") ? 1 : 1 + std::sqrt(steps) / 10;
        EXPECT_LT(left.energy, 1e-12 * more) << c.name << ' ' << integrator << ' ' << steps;
        EXPECT_LT(left.momentum, 1e-13 * more) << c.name << ' ' << integrator << ' ' << steps;
        EXPECT_LT(left.angular_momentum, 1e-12 * more)
            << c.name << ' ' << integrator << ' ' << steps;
      }
  }
}

// Series to a stated tolerance of 1e-3 rad leave some 4e-6 N m s in this case. The rule adds
// nothing to that: in steps of any length the same is left over, but for rounding of 400 N m s.
TEST(Balance, ShowsWhatAStatedToleranceLeavesWhateverTheStep) {
  Bench bench = pushedBox(0, 0, 0.1);
  bench.world.solver.tolerance = 1e-3;
  bench.world.solver.horizon = 2;
  bench.world.solver.tolerance_stated = true;
  std::vector<Vector3d> left;
  for (int steps : {1, 100}) {
    Simulation sim = tracked(bench, "auto", 2.0 / steps);
    run(sim, steps);
    left.push_back(sim.balance().angular_momentum);
  }
  EXPECT_GT(left[0].norm(), 1e-7);
  EXPECT_LT(left[0].norm(), 1e-3 * 400);
  EXPECT_LE((left[1] - left[0]).norm(), 1e-3 * left[0].norm());
}

// Of the row's order at least, for conserving and dissipating laws and every kind of wrench.
// Rounding of up to 1280 steps with some 15 kicks each stays below the floors.
TEST_P(BalanceOfEveryMethod, ClosesAtTheOrderOfTheIntegrator) {
  const Method& method = GetParam();
  if (method.claimsTo(kSolves)) GTEST_SKIP() << "has no order, see above";
  for (const Case& c : casesFor(method)) {
    Ladder energy(1e-10), momentum(1e-11), angular_momentum(1e-11);
    for (int steps = 40; steps <= 1280; steps *= 2) {
      Simulation sim = tracked(c.bench, method.name, 2.0 / steps);
      Leftover left;
      for (int i = 0; i < steps; ++i) {
        sim.step();
        left.include(sim.balance());
      }
      if (sim.maxSubsteps() > 1) continue;  // other steps were taken than asked for
      energy.add(steps, left.energy);
      momentum.add(steps, left.momentum);
      angular_momentum.add(steps, left.angular_momentum);
    }
    // no slope: it closes to rounding from the first or second step of the ladder on
    const double least = 0.9 * method.order - 0.1;
    EXPECT_GT(energy.slope(3).value_or(100), least) << c.name;
    EXPECT_GT(momentum.slope(3).value_or(100), least) << c.name;
    EXPECT_GT(angular_momentum.slope(3).value_or(100), least) << c.name;
  }
}

// A force fixed in the world at a point of the body: work = f · path of the point.
TEST(Balance, CountsTheWorkOfALeverAsForceTimesPath) {
  const Bench bench = interruptedPush();
  const PointWrench& push = bench.world.wrenches[0];
  Bench lever = bench;
  lever.world.wrenches[0].torque.setZero();
  const auto pointAt = [&](double t) {
    Simulation sim = lever.simulation("auto", t);
    sim.step();
    const BodyState& s = sim.body(0);
    return Vector3d(s.x_W + s.x_low_W + rotate(s.q_WP, push.point));
  };
  Simulation sim = tracked(lever, "auto", 0.1);
  run(sim, 10);
  const double work = push.force.dot(pointAt(push.end) - pointAt(push.start));
  EXPECT_NEAR(sim.exchanged().energy, work, 1e-13);  // of 4 J
  const Vector3d impulse = push.force * (push.end - push.start) + 2 * bench.world.g_W;
  EXPECT_LE((sim.exchanged().momentum - impulse).norm(), 1e-14);  // of 20 N s
}

// A ball that spins up about its own axis: ω = ω₀ + τ t/I, work = τ (ω₀ t + ½ τ t²/I).
TEST(Balance, CountsTheWorkOfACoupleAsTorqueTimesAngle) {
  Bench bench;
  bench.add(principalBody("ball", 1, {2, 2, 2}), tumbling({0, 0, 0}, {0, 0, 3}));
  PointWrench couple;
  couple.torque = {0, 0, 0.5};
  bench.world.wrenches.push_back(couple);
  Simulation sim = tracked(bench, "auto", 4);  // 14 rad in one step
  sim.step();
  EXPECT_NEAR(sim.exchanged().energy, 0.5 * (3 * 4 + 0.5 * 0.5 / 2 * 16), 1e-14);
}

// Of a body at speed v₀ and rate ω₀ about a principal axis, drag has dissipated after t
//   ½ m v₀² (1 − e^(−2 linear t/m)) + ½ I ω₀² (1 − e^(−2 angular t/I)).
TEST(Balance, CountsWhatDragDissipates) {
  Bench bench = thrown({0.8, 0, 1.5});
  bench.world.g_W.setZero();
  const Body& body = bench.world.bodies[0];
  bench.initial.bodies[0] = toBodyState(body, tumbling({3, 0, 0}, {0, 2, 0}));
  Simulation sim = tracked(bench, "dop853", 0.05);
  run(sim, 20);
  const double I = body.I.y();
  const double dissipated = 4.5 * -std::expm1(-2 * 0.8) + 0.5 * I * 4 * -std::expm1(-2 * 1.5 / I);
  EXPECT_NEAR(sim.exchanged().energy, -dissipated, 1e-12);
}

// Forces of a spring between bodies cancel; to the world it pulls, which the impulse has.
TEST(Balance, HasNoImpulseFromWithin) {
  Simulation pair = tracked(springPair(1), "dop853", 0.05);
  run(pair, 40);
  EXPECT_LE(pair.exchanged().momentum.norm(), 1e-15);
  EXPECT_LE(pair.exchanged().angular_momentum.norm(), 1e-14);
  EXPECT_LT(pair.exchanged().energy, -0.01);  // the damper's
  Simulation tied = tracked(boxOnSpring(), "dop853", 0.05);
  run(tied, 40);
  EXPECT_GT((tied.exchanged().momentum - 2 * 2 * tied.world().g_W).norm(), 1);
  EXPECT_EQ(tied.exchanged().energy, 0);  // all of it is potential
}

// Without wrenches the balance of the energy is its change, to the bit: the lecture's update gains
// energy in proportion to its step.
TEST(Balance, ShowsTheDriftOfTheLecturesUpdate) {
  std::vector<double> gains;
  for (double step : {0.01, 0.005}) {
    Simulation sim = tracked(freeBody(), "semi_implicit_euler", step);
    const double start = energyOf(sim);
    run(sim, static_cast<int>(2 / step));
    EXPECT_EQ(sim.balance().energy, energyOf(sim) - start);
    gains.push_back(sim.balance().energy);
  }
  EXPECT_GT(gains[1], 1e-3);
  EXPECT_NEAR(gains[0] / gains[1], 2, 0.1);
}

/// A constant pull on body 0 whose potential is stated wrongly, by a factor.
class MisstatedPull final : public ForceLaw {
 public:
  explicit MisstatedPull(double factor) : factor_(factor) {}
  const char* name() const override { return "misstated pull"; }
  std::vector<std::size_t> members() const override { return {0}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>&) const override {
    return std::make_shared<MisstatedPull>(factor_);
  }
  void addWrenches(const Bodies&, std::vector<Wrench>& wrenches) const override {
    wrenches[0].f_W.x() += kForce;
  }
  double potentialEnergy(const Bodies& at) const override {
    return -factor_ * kForce * at.states[0].x_W.x();
  }
  double externalPower(const Bodies&) const override { return 0; }
  unsigned needs() const override { return kCoupling; }

  static constexpr double kForce = 3;  // [N]

 private:
  double factor_;
};

TEST(Balance, ShowsAWrongPotential) {
  for (double factor : {1.0, 1.01}) {
    Bench bench;
    bench.add(principalBody("box", 2, {1, 2, 2.5}), BodyFrameMotion());
    bench.world.laws.push_back(std::make_shared<MisstatedPull>(factor));
    Simulation sim = tracked(bench, "strang", 0.01);
    run(sim, 200);
    const double path = 0.5 * MisstatedPull::kForce / 2 * 4;
    EXPECT_NEAR(sim.balance().energy, (1 - factor) * MisstatedPull::kForce * path, 1e-13);
  }
}

TEST(Balance, StartsAnewWhenAStateIsSetAndWithAReset) {
  const Bench bench = coupledBodies();
  Simulation sim = tracked(bench, "semi_implicit_euler", 0.1);
  const auto expectBlank = [&] {
    EXPECT_EQ(sim.balance().energy, 0);
    EXPECT_EQ(sim.balance().angular_momentum.norm(), 0);
    EXPECT_EQ(sim.exchanged().momentum.norm(), 0);
  };
  expectBlank();
  run(sim, 3);
  EXPECT_NE(sim.balance().energy, 0);
  sim.setState(0, bench.initial.bodies[1]);
  expectBlank();
  run(sim, 3);
  sim.reset(false);
  expectBlank();
}

TEST(Balance, IsUnknownUnlessTracked) {
  Simulation sim = freeBody().simulation("strang", 0.1);
  sim.step();
  EXPECT_TRUE(std::isnan(sim.balance().energy));
  EXPECT_TRUE(sim.exchanged().momentum.array().isNaN().all());
  sim.trackBalance();
  sim.step();
  EXPECT_FALSE(std::isnan(sim.balance().energy));
  sim.stopTracking();
  EXPECT_TRUE(std::isnan(sim.balance().energy));
}

TEST(Balance, LeavesTheRunItsBits) {
  for (const char* integrator : {"auto", "rk4", "strang"}) {
    for (const Bench& bench : {interruptedPush(), pushedBox(kWorld, kWorld)}) {
      Simulation watched = tracked(bench, integrator, 0.05);
      Simulation left_alone = bench.simulation(integrator, 0.05);
      run(watched, 40);
      run(left_alone, 40);
      const BodyState &a = watched.body(0), &b = left_alone.body(0);
      EXPECT_EQ(a.q_WP.coeffs(), b.q_WP.coeffs()) << integrator;
      EXPECT_EQ(a.L_P, b.L_P) << integrator;
      EXPECT_EQ(a.x_W, b.x_W) << integrator;
      EXPECT_EQ(watched.evaluations(), left_alone.evaluations()) << integrator;
    }
  }
}

// What a step exchanged that led nowhere is not counted: here more than there are numbers for.
TEST(Balance, IsThatOfTheLastGoodState) {
  Bench bench;
  bench.add(principalBody("box", 2, {1, 2, 2.5}), BodyFrameMotion());
  Simulation sim = tracked(bench, "strang", 10);
  sim.step();
  PointWrench blast;
  blast.force = {1e308, 0, 0};
  sim.applyWrench("", blast);
  EXPECT_THROW(sim.step(), SimulationDiverged);
  EXPECT_EQ(sim.exchanged().momentum.norm(), 0);
  sim.clearWrenches();
  sim.step();
  EXPECT_EQ(sim.exchanged().momentum.norm(), 0);
  EXPECT_EQ(sim.balance().energy, 0);
}

}  // namespace
}  // namespace rigid_body_sim
