#pragma once

#include <string>

#include "support/same_bits.hpp"
#include "support/same_state.hpp"
#include "support/worlds.hpp"

/// Runs in packs beside the same runs while the balance is tracked: then each body is stepped by
/// itself.
namespace rigid_body_sim::test {

inline void expectSameAsSingly(const Bench& bench, const std::string& integrator, int steps) {
  constexpr double kStep = 0.01;  // [s]
  Simulation packed = bench.simulation(integrator, kStep);
  Simulation singly = bench.simulation(integrator, kStep);
  singly.trackBalance();
  for (int i = 0; i < steps; ++i) {
    packed.step();
    singly.step();
    if (i % 10 == 0) expectSameBits(packed, singly);
  }
  expectSameBits(packed, singly);
  expectSameState(packed.state(), singly.state());
}

}  // namespace rigid_body_sim::test
