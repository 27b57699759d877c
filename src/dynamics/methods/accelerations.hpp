#pragma once

#include "dynamics/methods/system.hpp"

namespace rigid_body_sim {

/// How the bodies of a system move and accelerate at these states, by all that acts on them: one
/// evaluation of every wrench, with the forces of gravity kept apart.
std::vector<BodyMotion> motionsOf(const System& system, const SystemState& states);

/// The same of bodies that rest at these states: they do not accelerate, though the laws balance to
/// no more than a bound, and nothing but gravity is evaluated.
std::vector<BodyMotion> restOf(const System& system, const SystemState& states);

}  // namespace rigid_body_sim
