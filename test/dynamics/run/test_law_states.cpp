#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/contact_benches.hpp"
#include "support/refusal.hpp"
#include "support/worlds.hpp"

/// States of laws that a file may hold and no run has.
namespace rigid_body_sim {
namespace {

using test::Bench;

std::string faultOfState(const Simulation& sim, const State& state) {
  return test::refusalOf([&] { Simulation(sim.world(), state); });
}

/// A box that lies on the ground, a ball that touches it from above, on a tether, in a wind.
Simulation everyKindOfLaw() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, test::motionAt({0, 0, 0.1}), HalfSpace{},
               test::contactOf(1e5, 1.5, 3, 0.5));
  test::addBall(bench, 0.1, 1, test::motionAt({2, 0, 0.1}), HalfSpace{},
                test::contactOf(1e5, 1.5, 3, 0.5));
  test::addBall(bench, 0.1, 1, test::motionAt({2, 0, 0.29}), HalfSpace{},
                test::contactOf(1e5, 1.5, 3, 0.5));
  test::letTouch(bench, 1, 0.1, 2, 0.1, test::contactOf(1e5, 1.5, 3, 0.5));
  bench.world.laws.push_back(std::make_shared<Tether>(Spring::End{kWorld, {2, 0, 1}},
                                                      Spring::End{2, Vector3d::Zero()},
                                                      Tether::Constants{10, 0, 0.5}));
  MediumDrag::Coefficients drag;
  drag.quadratic.axes = {1, 1, 1};
  bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, Vector3d(1, 0, 0)));
  Simulation sim = bench.simulation("auto", 0.01);
  for (int i = 0; i < 5; ++i) sim.step();
  return sim;
}

}  // namespace

TEST(LawStates, MustTellOneOfTheModesOfTheirLaw) {
  const Simulation sim = everyKindOfLaw();
  const State state = sim.state();
  EXPECT_EQ(faultOfState(sim, state), "");
  std::size_t first = 0;
  for (std::size_t law = 0; law < sim.world().laws.size(); ++law) {
    const ForceLaw& of = *sim.world().laws[law];
    const std::size_t mode = first + (std::string(of.name()) == "drag" ? 3 : 0);
    for (double impossible : {1e300, 3.5, -2.0}) {
      State forged = state;
      forged.laws[mode] = impossible;
      EXPECT_EQ(faultOfState(sim, forged), "law " + std::to_string(law) + " (" + of.name() +
                                               "): its states must be those of one of its modes");
    }
    first += of.stateCount();
  }
}

TEST(LawStates, AreOfLawsThatActOnce) {
  const Simulation sim = everyKindOfLaw();
  State state = sim.state();
  for (MotionPlan& plan : state.plans)
    if (!plan.laws.empty()) plan.laws.push_back(plan.laws.back());
  EXPECT_NE(faultOfState(sim, state).find("one plan must have it, once"), std::string::npos);
}

TEST(LawStates, AreOfATimeThatStepsReach) {
  const Simulation sim = everyKindOfLaw();
  for (double impossible : {-0.01, 1e300}) {
    State state = sim.state();
    state.t = impossible;
    EXPECT_NE(faultOfState(sim, state).find("time must be a multiple of time_step, from 0 to"),
              std::string::npos);
  }
}

}  // namespace rigid_body_sim
