#pragma once

#include <cstddef>
#include <string>

#include <rigid_body_sim/GetState.h>
#include <rigid_body_sim/SetState.h>
#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

struct RequestedState {
  std::size_t body = 0;  ///< index; both of account only without fault
  BodyState state;
  std::string fault;  ///< one line saying which rule is broken and what was found; empty if none
};

/// The state that a request asks for. Faults: an unknown or fixed body, twist axes that are neither
/// the world's nor the body's, numbers that are not finite or too large for a finite momentum, a
/// quaternion whose norm is off 1 by more than 1e-3.
RequestedState takeState(const SetState::Request& request, const World& world,
                         const std::string& world_frame);

/// The answer to a request at a state of the world; its stamp is left to the caller. Refused: an
/// unknown body, twist axes that are neither the world's nor the body's.
GetState::Response tellState(const GetState::Request& request, const World& world,
                             const State& state, const std::string& world_frame);

}  // namespace rigid_body_sim
