#pragma once

#include <string>

#include "support/same_bits.hpp"
#include "support/same_state.hpp"
#include "support/worlds.hpp"

/// Runs in packs beside the same runs while the balance is tracked: then each body is stepped by
/// itself.
namespace rigid_body_sim::test {

struct PackedBesideSingle {
  PackedBesideSingle(const Bench& bench, const std::string& integrator)
      : packed(bench.simulation(integrator, 0.01)), singly(bench.simulation(integrator, 0.01)) {
    singly.trackBalance();
  }

  /// Both act, and take seven steps.
  template <class Act>
  void operator()(const Act& act) {
    for (Simulation* simulation : {&packed, &singly}) {
      act(*simulation);
      simulation->step(7);
    }
    expectSameBits(packed, singly);
  }

  Simulation packed, singly;
};

inline void expectSameAsSingly(const Bench& bench, const std::string& integrator, int steps) {
  PackedBesideSingle both(bench, integrator);
  for (int i = 0; i < steps; ++i) {
    both.packed.step();
    both.singly.step();
    if (i % 10 == 0) expectSameBits(both.packed, both.singly);
  }
  expectSameBits(both.packed, both.singly);
  expectSameState(both.packed.state(), both.singly.state());
}

}  // namespace rigid_body_sim::test
