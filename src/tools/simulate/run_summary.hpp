#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

#include "tools/simulate/input_effects.hpp"

namespace rigid_body_sim {

/// Where each moving body went and what became of its energy and momentum, a few lines of text.
/// A body on which nothing but gravity acts must conserve them, so the text says how well it does:
///   energy ½ p²/m + ½ Σ Lᵢ²/Iᵢ − m g·x,  momentum p − m g t,  angular momentum L,
/// each difference relative to the greatest value. For every other body the text says what changed
/// them, and by how much. inputs: of each body, or empty.
/// world: as it is at the last state.
std::string runSummary(const World& world, const State& first, const State& last,
                       const std::vector<InputEffects>& inputs);

}  // namespace rigid_body_sim
