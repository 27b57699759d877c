#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Whether a state can be one of the world: bodies, states of laws and of actuators are as many,
/// and the world has the changes that the state has. Throws std::invalid_argument, one line, where
/// not.
void requireStateOf(const World& world, const State& state);

}  // namespace rigid_body_sim
