#pragma once

#include "dynamics/methods/system.hpp"

namespace rigid_body_sim {

/// How the bodies of a system move and accelerate at these states, by all that acts on them: one
/// evaluation of every wrench, with the forces of gravity kept apart.
std::vector<BodyMotion> motionsOf(const System& system, const SystemState& states);

}  // namespace rigid_body_sim
