#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/random_bodies.hpp"
#include "support/same_state.hpp"
#include "support/tether_drop.hpp"
#include "support/worlds.hpp"

/// A line that pulls and never pushes.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::droppedBall;

const test::TetherDrop fallen(3);

/// Whether a run at a time exerts a force, by the mode of its only law.
bool isTaut(const Simulation& sim, double t) { return sim.sample(t).laws[0] == 1; }

/// [s] The instant within the next step at which the mode changes to or from taut.
double changeWithin(const Simulation& sim, double from, double to) {
  const bool at_end = isTaut(sim, to);
  for (double middle = (from + to) / 2; middle > from && middle < to; middle = (from + to) / 2)
    (isTaut(sim, middle) == at_end ? to : from) = middle;
  return to;
}

}  // namespace

// Rounding of times and of the motion; dop853 at steps of 2.5 ms errs by less. The pull is zero
// where k s + c s′ = 0, which TetherDrop finds from the closed form of the damped oscillator:
// 0.563748 s with k = 200 N/m, c = 3 N s/m.
TEST(Tether, IsTautAndSlackAtTheInstantsOfTheClosedForm) {
  constexpr double h = 0.0025;
  Simulation sim = droppedBall().simulation("dop853", h);
  std::vector<double> instants;
  while (sim.time() < 0.6) {
    if (isTaut(sim, sim.time()) != isTaut(sim, sim.time() + h))
      instants.push_back(changeWithin(sim, sim.time(), sim.time() + h));
    sim.step();
    EXPECT_NEAR(sim.body(0).x_W.z(), fallen.z(sim.time()), 1e-13);
  }
  ASSERT_EQ(instants.size(), 2u);
  EXPECT_NEAR(instants[0], static_cast<double>(fallen.tautAt()), 1e-13);
  EXPECT_NEAR(instants[1], static_cast<double>(fallen.limpAt()), 1e-13);
  EXPECT_NEAR(instants[0], 0.316228, 5e-7);
  EXPECT_NEAR(instants[1], 0.563748, 5e-7);
}

// Without damping nothing is dissipated; with it, what the balance says.
TEST(Tether, KeepsTheBalanceThroughEveryMode) {
  for (double damping : {0.0, 3.0}) {
    Simulation sim = droppedBall(damping).simulation("dop853", 0.0025);
    sim.trackBalance();
    while (sim.steps() < 400) sim.step();
    EXPECT_NEAR(sim.balance().energy, 0, 1e-12) << damping;
    EXPECT_NEAR(sim.balance().momentum.norm(), 0, 1e-12) << damping;
    if (damping > 0) {
      EXPECT_LT(sim.exchanged().energy, -0.5);
    } else {
      EXPECT_NEAR(sim.exchanged().energy, 0, 1e-12);
    }
  }
}

TEST(Tether, CostsItsBodyNothingWhileItIsSlack) {
  for (double step : {0.001, 0.03, 0.2}) {
    Simulation sim = droppedBall().simulation("auto", step);
    while (sim.time() + step < 0.316) sim.step();
    EXPECT_TRUE(sim.plans()[0].integrator.empty()) << step;
    EXPECT_EQ(sim.evaluations(), 0) << step;
    while (sim.time() < 0.6 - 1e-9) sim.step();
    EXPECT_GT(sim.evaluations(), 0) << step;
    EXPECT_TRUE(sim.plans()[0].integrator.empty()) << step;
    EXPECT_NEAR(sim.body(0).x_W.z(), fallen.z(sim.time()), 1e-9) << step;
  }
}

// A throw that leaves the reach of the tether for 2 ms in the midst of a step of half a second.
TEST(Tether, IsTautHoweverShortlyWhateverTheStep) {
  std::vector<double> speeds;
  for (double step : {0.5, 0.001}) {
    Bench bench;
    bench.world.g_W = {0, 0, -10};
    BodyFrameMotion motion = test::tumbling({0, 0, 4}, {3, 1, -2});
    bench.add(test::principalBody("ball", 1, {0.1, 0.15, 0.2}), motion);
    // the apex is 0.8 m up
    bench.world.laws.push_back(std::make_shared<Tether>(Spring::End{kWorld, Vector3d::Zero()},
                                                        Spring::End{0, Vector3d::Zero()},
                                                        Tether::Constants{1000, 0, 0.8 - 5e-6}));
    bench.world.solver.tolerance = 1e-12;
    Simulation sim = bench.simulation("auto", step);
    while (sim.time() < 0.5 - 1e-9) sim.step();
    EXPECT_GT(sim.evaluations(), 0) << step;
    speeds.push_back(sim.body(0).p_W.z());
  }
  EXPECT_NEAR(speeds[0], speeds[1], 1e-10);
  EXPECT_LT(speeds[0], -1 - 1e-6);
}

// The damper lets go for 22 ms, 0.025 s after a step of 0.1 s has begun.
TEST(Tether, IsLimpHoweverShortlyWhateverTheStep) {
  std::vector<double> heights;
  for (double step : {0.001, 0.1, 0.2, 0.5}) {
    Bench bench = droppedBall();
    bench.initial.bodies[0].x_W.z() = -0.5;
    bench.world.laws = {std::make_shared<Tether>(Spring::End{kWorld, Vector3d::Zero()},
                                                 Spring::End{0, Vector3d::Zero()},
                                                 Tether::Constants{200, 3, 1})};
    Simulation sim = bench.simulation("auto", step);
    while (sim.time() < 2 - 1e-9) sim.step();
    heights.push_back(sim.body(0).x_W.z());
    EXPECT_NEAR(heights.back(), heights.front(), 1e-9) << step;
  }
}

/// [m] A mass of 1 kg that falls from rest at `lowest` below the place where its tether, of
/// stiffness k, becomes taut: it rises on a sine, flies, and falls back. Above that place: < 0.
double bounceOnTether(double k, double lowest, double t) {
  constexpr double g = 10;
  const double w = std::sqrt(k), rest = g / k, amplitude = lowest - rest;
  const double rise = std::acos(-rest / amplitude) / w;  // to where it is slack
  const double speed = amplitude * w * std::sin(w * rise), flight = 2 * speed / g;
  const double within = std::fmod(t, 2 * rise + flight), flown = within - rise;
  if (flown > 0 && flown < flight) return -(speed * flown - g * flown * flown / 2);
  const double turned = w * (flown > 0 ? 2 * rise + flight - within : within);
  return rest + amplitude * std::cos(turned);
}

// It is slack for 1.3 to 40 ms in every bounce, anywhere in steps that are up to a hundred times as
// long. What is left is what the integrator errs by, and nothing where that is small.
TEST(Tether, IsSlackHoweverShortlyWhateverTheStep) {
  for (double k : {20.0, 500.0}) {
    for (double above : {1e-2, 1e-4}) {
      for (double step : {0.01, 0.07, 0.1, 0.2}) {
        Bench bench = droppedBall();
        const double lowest = (2 + above) * 10 / k;
        bench.initial.bodies[0].x_W.z() = -1 - lowest;
        bench.world.laws = {std::make_shared<Tether>(Spring::End{kWorld, Vector3d::Zero()},
                                                     Spring::End{0, Vector3d::Zero()},
                                                     Tether::Constants{k, 0, 1})};
        bench.world.solver.tolerance = 1e-9;
        bench.world.solver.tolerance_stated = true;
        bench.world.solver.horizon = 6;
        Simulation sim = bench.simulation("auto", step);
        while (sim.time() < 6 - step) {
          sim.step();
          ASSERT_NEAR(sim.body(0).x_W.z(), -1 - bounceOnTether(k, lowest, sim.time()), 2e-9)
              << k << " N/m, " << above << ", " << step << " s, at " << sim.time();
        }
      }
    }
  }
}

// Every integrator looks for it.
TEST(Tether, IsFoundSlackByEveryIntegrator) {
  for (const char* integrator :
       {"dop853", "rk4", "strang", "magnus4", "kahan_li8", "blanes_moan6"}) {
    Bench bench = droppedBall();
    bench.initial.bodies[0].x_W.z() = -1.0005;
    bench.initial.bodies[0].p_W.z() = 0.15;
    bench.world.laws = {std::make_shared<Tether>(Spring::End{kWorld, Vector3d::Zero()},
                                                 Spring::End{0, Vector3d::Zero()},
                                                 Tether::Constants{10, 0, 1})};
    Simulation sim = bench.simulation(integrator, 0.05);
    sim.step();
    // it flies for 27 ms; its pull is far below its weight
    EXPECT_NEAR(sim.body(0).x_W.z(), -1.0005 + 0.15 * 0.05 - 5 * 0.05 * 0.05, 1e-3) << integrator;
  }
}

// Two bodies in free fall, of which one hangs on a spring: its motion is not known beforehand.
TEST(Tether, PullsTwoBodiesOfWhichOneIsIntegrated) {
  std::vector<Vector3d> ends;
  for (double step : {0.05, 0.002}) {
    Bench bench;
    bench.world.solver.tolerance = 1e-11;
    bench.add(test::principalBody("held", 2, {0.1, 0.15, 0.2}),
              test::tumbling({0, 1, 0}, {1, 2, 0}));
    BodyFrameMotion motion = test::tumbling({2, 0, 0}, {0, 0, 1});
    motion.x_W.x() = 0.3;
    bench.add(test::principalBody("free", 1, {0.1, 0.15, 0.2}), motion);
    bench.addSpring({kWorld, Vector3d::Zero()}, {0, {0.1, 0, 0}}, {20, 0, 0});
    bench.world.laws.push_back(std::make_shared<Tether>(
        Spring::End{0, {0, 0.1, 0}}, Spring::End{1, {0, 0, 0.1}}, Tether::Constants{300, 1, 1}));
    Simulation sim = bench.simulation("auto", step);
    sim.trackBalance();
    while (sim.time() < 2 - 1e-9) sim.step();
    EXPECT_LT(sim.body(1).p_W.x(), 1.9) << step;
    EXPECT_LT(sim.exchanged().energy, 0) << step;
    EXPECT_NEAR(sim.balance().energy, 0, 1e-9) << step;
    ends.push_back(sim.body(1).x_W);
  }
  EXPECT_LE((ends[0] - ends[1]).norm(), 1e-8);
}

// Only the tether acts: momenta stay, and the two part and solve again.
TEST(Tether, KeepsTheMomentaOfAPair) {
  Bench bench;
  bench.world.solver.tolerance = 1e-12;
  BodyFrameMotion motion = test::tumbling({3, 0, 0.5}, {0, 2, 1});
  bench.add(test::principalBody("a", 1, {0.1, 0.15, 0.2}), BodyFrameMotion());
  bench.add(test::principalBody("b", 2, {0.1, 0.15, 0.2}), motion);
  bench.world.laws.push_back(std::make_shared<Tether>(
      Spring::End{0, {0.1, 0, 0}}, Spring::End{1, {0, 0.2, 0}}, Tether::Constants{100, 0.5, 1}));
  Simulation sim = bench.simulation("auto", 0.01);
  const auto sum = [&](Vector3d& p, Vector3d& L) {
    p = L = Vector3d::Zero();
    for (const BodyState& s : sim.state().bodies) {
      p += s.p_W;
      L += (s.x_W + s.x_low_W).cross(s.p_W) + s.L_W;
    }
  };
  Vector3d p, L, p_end, L_end;
  sum(p, L);
  EXPECT_EQ(sim.plans().size(), 2u);
  while (sim.steps() < 40) sim.step();
  EXPECT_EQ(sim.plans().size(), 1u);
  while (sim.steps() < 100) sim.step();
  sum(p_end, L_end);
  EXPECT_LE((p_end - p).norm(), 1e-13);
  EXPECT_LE((L_end - L).norm(), 1e-11);
  EXPECT_GT(sim.body(0).p_W.norm(), 0.1);
}

TEST(Tether, GoesOnFromAStateWithTheSameBits) {
  for (const char* name : {"dop853", "auto"})
    test::expectToGoOnTheSame(droppedBall().simulation(name, 0.01), {3, 40, 57, 70});
}

// At the start, and where a state is set, it is taut or limp if the ends are further apart.
TEST(Tether, TakesItsModeFromWhereItsEndsAre) {
  for (const char* name : {"dop853", "auto"}) {
    Bench bench = droppedBall();
    bench.initial.bodies[0].x_W.z() = -0.6;
    Simulation sim = bench.simulation(name, 0.01);
    EXPECT_EQ(sim.state().laws[0], 1) << name;
    BodyState state = sim.body(0);
    state.p_W.z() = 30;
    sim.setState(0, state);
    EXPECT_EQ(sim.state().laws[0], 2) << name;
    state.x_W.z() = -0.1;
    sim.setState(0, state);
    EXPECT_EQ(sim.state().laws[0], 0) << name;
    state.x_W.z() = -1;
    state.p_W.z() = 0;
    sim.setState(0, state);
    EXPECT_EQ(sim.state().laws[0], 1) << name;
  }
}

// Central differences over dt = 1e-6 s: dt² times a third derivative of up to some 1e7 J/s³, and
// the rounding of energies of some 1e3 J over dt.
TEST(Tether, PullsWithThePowerOfItsPotentialAndItsDamper) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Draw draw(seed);
    Bench bench;
    for (int i = 0; i < 2; ++i) {
      bench.world.bodies.push_back(draw.box(1));
      bench.initial.bodies.push_back(draw.state(bench.world.bodies.back(), draw.uniform(0, 5)));
    }
    bench.initial.bodies[1].x_W.x() += 30;
    bench.world.laws.push_back(std::make_shared<Tether>(Spring::End{0, {0.3, -0.2, 0.5}},
                                                        Spring::End{1, {-0.1, 0.4, 0.2}},
                                                        Tether::Constants{2, 0.3, 0.7}));
    constexpr double dt = 1e-6;
    bench.initial.laws = {1};
    Simulation sim = bench.simulation("dop853", 2 * dt);
    const State middle = sim.sample(dt);
    sim.step();
    const double rate = (mechanicalEnergy(sim.world(), sim.state()) -
                         mechanicalEnergy(sim.world(), bench.initial)) /
                        (2 * dt);
    const std::vector<const Body*> bodies{&sim.world().bodies[0], &sim.world().bodies[1]};
    const double power =
        sim.world().laws[0]->externalPower({bodies, middle.bodies, middle.laws.data()});
    EXPECT_LE(power, 0);
    EXPECT_NEAR(rate, power, 5e-6 * (1 + std::abs(power))) << seed;
  }
}

}  // namespace rigid_body_sim
