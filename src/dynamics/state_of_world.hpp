#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Throws std::invalid_argument, one line, unless a state can be one of the world: it has as many
/// bodies, states of laws and of actuators, and no changes where the world has none.
void requireStateOf(const World& world, const State& state);

}  // namespace rigid_body_sim
