#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Whether two worlds differ in anything that moves their bodies or says how they are advanced:
/// bodies, states, wrenches, commands, solver, and what their laws do at states about the initial
/// ones. Names of frames, looks and IMUs move nothing.
bool differInMotion(const World& a, const State& initial_a, const World& b, const State& initial_b);

}  // namespace rigid_body_sim
