#pragma once

#include <string>

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Where each moving body went and what became of its energy and momentum, a few lines of text.
/// A body on which no wrench acted must keep them, so the text says by how much it did not:
///   energy ½ p²/m + ½ Σ Lᵢ²/Iᵢ − m g·x,  momentum p − m g t,  angular momentum L,
/// each relative to its greatest value. For a pushed body the text says what the pushes changed.
std::string runSummary(const World& world, const State& first, const State& last);

}  // namespace rigid_body_sim
