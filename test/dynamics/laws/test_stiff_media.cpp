#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/buoyancy.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/spring.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/random_bodies.hpp"
#include "support/worlds.hpp"

/// Media so stiff that nothing could follow them in steps: in closed form where there is one, else
/// refused in a line that says what is too fast and what to do.
namespace rigid_body_sim {
namespace {

using test::Bench;
using Coefficients = MediumDrag::Coefficients;

const Vector3d kStiffGravity{0, 0, -9.81}, kStiffWind{3, -1, 0.5}, kStiffStart{1, 2, 8};

Bench stiffBench(const Coefficients& drag, const Vector3d& w = {5, 1, -3}) {
  Bench bench;
  bench.world.g_W = kStiffGravity;
  bench.add(test::principalBody("ball", 2, {0.1, 0.15, 0.2}), test::tumbling(kStiffStart, w));
  bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, kStiffWind));
  return bench;
}

/// Why a step cannot be taken; empty where it can.
std::string divergenceOf(const Bench& bench, double time_step) {
  Simulation sim = bench.simulation("auto", time_step);
  try {
    sim.step();
  } catch (const SimulationDiverged& diverged) {
    return diverged.what();
  }
  return "";
}

}  // namespace

// v = v_t + (v₀ − v_t) e^(−kt),  x = v_t t + (v₀ − v_t) (1 − e^(−kt))/k,  in 64 bits where doubles
// would cancel
TEST(LinearMediumDrag, IsExactHoweverStiffOrWeakItIs) {
  for (const double linear : {0.0, 1e-12, 1e-3, 1.0, 1e4, 1e10, 1e40}) {
    Coefficients drag;
    drag.linear.alike = linear;
    Simulation sim = stiffBench(drag).simulation("auto", 0.5);
    while (sim.steps() < 6) sim.step();
    EXPECT_EQ(sim.evaluations(), 0);
    for (int i = 0; i < 3; ++i) {
      using Real = long double;
      const Real k = Real(linear) / 2, t = 3, g = kStiffGravity[i],
                 u = kStiffStart[i] - kStiffWind[i];
      // below, the terms of k t by which the parabola differs are cut where they are rounding
      const bool weak = linear < 1e-9L;
      const Real decay = weak ? t - k * t * t / 2 : -std::expm1(-k * t) / k;
      const Real v = kStiffWind[i] + u * (weak ? 1 - k * t : std::exp(-k * t)) + g * decay;
      const Real x = kStiffWind[i] * t + u * decay +
                     g * (weak ? t * t / 2 - k * t * t * t / 6 : (t - decay) / k);
      // eight roundings of numbers up to the size of wind and path
      EXPECT_NEAR(sim.body(0).p_W[i] / 2, double(v), 2e-15 * (9 + std::abs(double(v)))) << linear;
      EXPECT_NEAR(sim.body(0).x_W[i], double(x), 4e-15 * (27 + std::abs(double(x)))) << linear;
    }
  }
}

// What little a wind that is fast moves a body at rest: v = (1 − e^(−kt)) w, and its integral.
TEST(LinearMediumDrag, KeepsTheDigitsOfWhatALittleOfItMoves) {
  struct Case {
    double mass, linear, wind, t;
  };
  for (const Case& c : {Case{1, 1e-9, 10, 1}, Case{1000, 1e-6, 7500, 10}, Case{1, 1e-12, 3, 2},
                        Case{1e12, 1e-12, 3, 2}, Case{1, 0.9, 3, 1}, Case{1, 1.1, 3, 1}}) {
    Bench bench;
    bench.add(test::principalBody("ball", c.mass, {1, 1, 1}), {});
    Coefficients drag;
    drag.linear.alike = c.linear;
    bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, Vector3d(c.wind, 0, 0)));
    Simulation sim = bench.simulation("auto", c.t);
    sim.step();
    using Real = long double;
    const Real k = Real(c.linear) / c.mass, z = k * c.t;
    const Real v = -std::expm1(-z) * c.wind;
    const Real x =
        z < 1e-6L ? z * c.t * c.wind * (0.5L - z / 6) : (z + std::expm1(-z)) / k * c.wind;
    // four roundings of each, and of the mean decay in the path as many more
    EXPECT_NEAR(sim.body(0).p_W.x() / c.mass, double(v), 1e-15 * double(v)) << c.linear;
    EXPECT_NEAR(sim.body(0).x_W.x(), double(x), 2e-15 * double(x)) << c.linear;
  }
}

// Where the translation goes by itself, the rotation is a series beside it: under drag of rotation
// along axes, levers, lift off the centre and couples, all that dop853 evaluates force by force.
TEST(LinearMediumDrag, LeavesTheRotationToItsSeries) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    Draw draw(seed);
    Bench bench;
    bench.world.g_W = kStiffGravity;
    bench.world.bodies.push_back(draw.box(1));
    bench.initial.bodies.push_back(draw.state(bench.world.bodies[0], 2));
    Coefficients drag;
    drag.linear.alike = draw.uniform(0, 3);
    drag.angular = {0.1, Vector3d(0.02, 0.1, 0.05)};
    drag.R_PD = draw.attitude().toRotationMatrix();
    bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, draw.vector(3)));
    bench.world.laws.push_back(
        std::make_shared<Buoyancy>(0, 0.5, draw.vector(0.2), bench.world.g_W));
    PointWrench push;
    push.force = draw.vector(2);
    push.torque = draw.vector(0.1);
    push.point = draw.vector(0.2);
    push.start = 0.1234;
    push.end = 0.777;
    bench.world.wrenches.push_back(push);
    Simulation sim = bench.simulation("auto", 0.01);
    while (sim.steps() < 100) sim.step();
    EXPECT_EQ(sim.evaluations(), 0);
    const BodyState a = sim.body(0), b = bench.run("dop853", 1, 1000).bodies[0];
    // of dop853 at 1 ms, as in Medium.IsSolvedAsAnIntegratorFollowsIt
    EXPECT_LE(distanceBetween(a, b) + angleBetween(a.q_WP, b.q_WP), 2e-11) << seed;
    EXPECT_LE((a.p_W - b.p_W).norm() + (a.L_W - b.L_W).norm(), 2e-11) << seed;
  }
}

TEST(LinearMediumDrag, AccountsForItsEnergyHoweverStiffItIs) {
  for (const double linear : {1e-3, 1.0, 1e4, 1e10}) {
    Coefficients drag;
    drag.linear.alike = linear;
    drag.angular.alike = 0.1;
    Simulation sim = stiffBench(drag).simulation("auto", 0.5);
    sim.trackBalance();
    while (sim.steps() < 6) sim.step();
    // the work of gravity, and what the wind does through drag; and the rounding of a steady force,
    // of which the meter sees the difference of p/m and the wind, times the drag
    const double wind = kStiffWind.norm(), scale = 100 + std::abs(sim.exchanged().energy);
    const double force = 4 * std::numeric_limits<double>::epsilon() * linear * wind;
    EXPECT_LT(std::abs(sim.balance().energy), 1e-13 * scale + force * wind * sim.time()) << linear;
    EXPECT_LT(sim.balance().momentum.norm(), 1e-13 * scale + force * sim.time()) << linear;
  }
}

// To nothing, where its series lose term after term to underflow.
TEST(MediumDrag, LeavesWhatItHasStoppedAtRest) {
  struct Case {
    double inertia;
    Vector3d angular, linear;
    double time_step;
    int steps;
  };
  const Vector3d none = Vector3d::Zero(), all = Vector3d::Ones();
  for (const Case& each :
       {Case{1, 1e20 * all, none, 0.01, 100}, Case{1, 1e16 * all, none, 0.01, 100},
        Case{1, 1e12 * all, none, 1, 20}, Case{1e-18, 1e-3 * all, none, 0.01, 20},
        Case{1, Vector3d(1e18, 3e19, 1e20), none, 0.01, 3}, Case{1, none, 1e16 * all, 10, 100},
        Case{1, 1e10 * all, 1e12 * all, 100, 20}}) {
    Bench bench;
    bench.add(test::principalBody("ball", 2, each.inertia * Vector3d(0.1, 0.15, 0.2)),
              test::tumbling(kStiffStart, {1, 2, 3}));
    Coefficients drag;
    drag.angular.axes = each.angular;
    drag.linear.axes = each.linear;
    bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, Vector3d::Zero()));
    Simulation sim = bench.simulation("auto", each.time_step);
    while (sim.steps() < each.steps) sim.step();
    const Vector3d stopped = each.angular.isZero(0) ? sim.body(0).p_W : sim.body(0).L_P;
    EXPECT_EQ(stopped, none) << each.angular.transpose() << ", " << each.linear.transpose();
    EXPECT_TRUE(sim.body(0).x_W.allFinite());
    const double free_path = kStiffStart.norm() * each.time_step * each.steps;
    EXPECT_LE(sim.body(0).x_W.norm(), free_path * (1 + 1e-14));  // a hundred steps' rounding
  }
}

// Drag about x alone sets the unit of time; in it, the decay about y shrinks by 1e-17 to 1e-40 a
// term. ω = ω₀ e^(−kt), θ = ω₀ (1 − e^(−kt))/k.
TEST(MediumDrag, IsFollowedBesideOneThatIsFarStiffer) {
  for (const double stiff : {1e16, 1e17, 1e18, 1e20, 1e40}) {
    Bench bench;
    bench.add(test::principalBody("ball", 2, {0.1, 0.15, 0.2}),
              test::tumbling(Vector3d::Zero(), {0, 2, 0}));
    Coefficients drag;
    drag.angular.axes = {stiff, 0.3, 0.1};
    bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, Vector3d::Zero()));
    Simulation sim = bench.simulation("auto", 0.1);
    while (sim.steps() < 10) sim.step();
    // k = 2/s, t = 1 s; some ten steps' rounding
    EXPECT_NEAR(sim.body(0).L_P.y(), 0.3 * std::exp(-2), 1e-15) << stiff;
    const Quaterniond exact(Eigen::AngleAxisd(-std::expm1(-2), Vector3d::UnitY()));
    EXPECT_LE(angleBetween(sim.body(0).q_WP, exact), 4e-15) << stiff;
  }
}

// At 1 s, where the next number is farther than its series holds.
TEST(MediumDrag, TooStiffToBeFollowedIsNamedWithWhatToDo) {
  Coefficients drag;
  drag.linear.axes = Vector3d::Constant(1e40);
  Bench bench = stiffBench(drag);
  bench.initial.t = 1;
  EXPECT_EQ(divergenceOf(bench, 0.01),
            "t = 1 s: body 'ball': the motion is too fast to be followed: drag slows it down at "
            "5e+39/s; weaker drag is needed");
}

// Where nothing turns, too: the lever squares to more than a number, or the speed through the wind.
TEST(MediumDrag, BeyondNumbersIsNamedWithWhatToDo) {
  Coefficients lever, in_wind;
  lever.linear.alike = 1;
  lever.center_P = {1e300, 0, 0};
  in_wind.quadratic.axes = Vector3d::Ones();
  const auto fault_of = [](const Coefficients& drag, const Vector3d& wind) {
    Bench bench;
    bench.add(test::principalBody("ball", 2, {0.1, 0.15, 0.2}),
              test::tumbling(kStiffStart, Vector3d::Zero()));
    bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, wind));
    return divergenceOf(bench, 0.01);
  };
  for (const std::string& fault :
       {fault_of(lever, Vector3d::Zero()), fault_of(in_wind, {1e200, 0, 0})})
    EXPECT_EQ(fault,
              "t = 0 s: body 'ball': the motion is too fast to be followed: drag changes it faster "
              "than numbers reach; weaker drag is needed");
}

TEST(Buoyancy, BeyondNumbersIsNamedWithWhatToDo) {
  Bench bench;
  bench.world.g_W = kStiffGravity;
  bench.add(test::principalBody("ball", 2, {0.1, 0.15, 0.2}),
            test::tumbling(kStiffStart, Vector3d::Zero()));
  bench.world.laws.push_back(
      std::make_shared<Buoyancy>(0, 1e308, Vector3d(1e10, 0, 0), kStiffGravity));
  EXPECT_EQ(divergenceOf(bench, 0.01),
            "t = 0 s: body 'ball': the motion is too fast to be followed: buoyancy turns it faster "
            "than numbers reach; less buoyancy, or a centre nearer to that of mass, is needed");
}

TEST(SteppedLaws, TooStiffToBeFollowedAreNamedWithWhatToDo) {
  const Spring::End body{0, {0.1, 0, 0}}, world{kWorld, {0, 0, 3}};
  Coefficients linear, quadratic;
  linear.linear.alike = 1e10;
  quadratic.quadratic.alike = 1e20;
  const auto dragBy = [](const Coefficients& drag) {
    return std::make_shared<MediumDrag>(0, drag, Vector3d::Zero());
  };
  const auto springOf = [&](double stiffness) {
    return std::make_shared<Spring>(body, world, Spring::Constants{stiffness, 0, 0});
  };
  const auto taut = std::make_shared<Tether>(body, world, Tether::Constants{1e300, 0, 1e-300});
  struct Case {
    const char* too_fast;
    std::vector<std::shared_ptr<const ForceLaw>> laws;
  };
  for (const Case& each : {Case{"spring", {springOf(1e300)}}, Case{"tether", {taut}},
                           Case{"drag", {springOf(1), dragBy(linear)}},
                           Case{"drag", {springOf(1), dragBy(quadratic)}}}) {
    Bench bench;
    bench.world.g_W = kStiffGravity;
    bench.add(test::principalBody("ball", 2, {0.1, 0.15, 0.2}),
              test::tumbling(kStiffStart, {5, 1, -3}));
    bench.world.laws = each.laws;
    const std::string fault = divergenceOf(bench, 0.01), name = each.too_fast;
    EXPECT_EQ(fault.rfind("t = 0 s: body 'ball': a step spans ", 0), 0U) << fault;
    EXPECT_NE(
        fault.find(" rad of what " + name +
                   " makes swing or slow down, more than dop853 follows in 100000 substeps; a "
                   "shorter time_step or weaker " +
                   name + " is needed"),
        std::string::npos)
        << fault;
  }
}

}  // namespace rigid_body_sim
