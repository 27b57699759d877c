#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/GetState.h>
#include <rigid_body_sim/SetState.h>
#include <rigid_body_sim/dynamics/input.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Both requests name the axes of the twist: by the name of the world frame or of the body, or, as
/// in a scene, by the word `world` or `body`, or by the body's frame on tf, which body_frames has
/// for each body (TfFrames; empty: none other than its name). Both functions throw
/// std::invalid_argument, one line, for other axes and for an unknown body.

/// What ~set_state asks for. Refused, too: a fixed body, numbers that are not finite or too large
/// for a finite momentum, a quaternion whose norm is off 1 by more than 1e-3. A motion in world
/// axes whose quaternion is unit to rounding is taken as it is, to the last bit.
StateInput takeState(const SetState::Request& request, const World& world,
                     const std::string& world_frame,
                     const std::vector<std::string>& body_frames = {});

/// The answer to ~get_state at a state of the world; its stamp is left to the caller.
GetState::Response reportState(const GetState::Request& request, const World& world,
                               const State& state, const std::string& world_frame,
                               const std::vector<std::string>& body_frames = {});

}  // namespace rigid_body_sim
