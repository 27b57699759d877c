#pragma once

#include <cstddef>
#include <string>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/SetState.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// What changes a run from outside is brought to the form of the message Input, and changes the
/// simulation by applyInput alone, in the node as in a replay. Every number passes unchanged.

/// A wrench that is applied; its indices are of bodies of the world.
Input wrenchInput(const std::string& slot, const PointWrench& wrench, const World& world);

/// Ends the wrenches of a body, empty: of all; those of one slot, empty: of every slot.
Input clearInput(const std::string& body, const std::string& slot);

Input setStateInput(const SetState::Request& request);

/// Applies an input at a step boundary. Throws std::invalid_argument, one line, and changes
/// nothing, for what names an unknown body or breaks a rule of the simulation.
void applyInput(const Input& input, const std::string& world_frame, Simulation& simulation);

}  // namespace rigid_body_sim
