#pragma once

#include <string>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/dynamics/input.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Inputs as they are recorded: by the names of bodies, every number unchanged, so that what is
/// read from a record is to the last bit what was applied.

/// Header, run, number, step and time are left to the caller. A state is given in world axes.
Input toMessage(const SimulationInput& input, const World& world, const std::string& world_frame);

/// The inverse. Throws std::invalid_argument, one line, for an unknown kind or body, and for a
/// state that breaks a rule of ~set_state.
SimulationInput toInput(const Input& message, const World& world, const std::string& world_frame);

}  // namespace rigid_body_sim
