#pragma once

#include "benchmark/peers.hpp"

namespace rigid_body_sim::peers {

/// The attitude at the end of a body on a spring or with wheels, by code that shares nothing with
/// ours or with the engines: the body's axes and the angular momentum in the world, in long double.
/// Prints how far it can be trusted: what twice the step makes of it.
Quaternion4 truthApart(const Problem& problem);

}  // namespace rigid_body_sim::peers
