#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/totals.hpp>

#include "support/thrown_bodies.hpp"

/// Energy of bodies in contact, over many scenes.
namespace rigid_body_sim {
namespace {

// Over steps of the world; 1000 scenes with RIGID_BODY_SIM_LONG_TESTS.
TEST(ContactEnergy, NeverGrowsInRandomScenes) {
  test::Thrower thrower(57);
  const int rounds = std::getenv("RIGID_BODY_SIM_LONG_TESTS") ? 200 : 4;
  for (int round = 0; round < rounds; ++round)
    for (const test::ThrownKind kind : test::kThrownKinds) {
      Simulation sim = thrower.next(kind).bench.simulation("auto", 5e-3);
      double last = mechanicalEnergy(sim.world(), sim.state());
      const double start = std::abs(last);
      std::size_t touches = 0;
      while (sim.time() < 1) {
        sim.step();
        touches += sim.contactEvents().size();
        const double now = mechanicalEnergy(sim.world(), sim.state());
        EXPECT_LT(now - last, 1e-12 * start) << round << ' ' << int(kind) << ' ' << sim.time();
        last = now;
      }
      EXPECT_GT(touches, 0U);
    }
}

}  // namespace
}  // namespace rigid_body_sim
