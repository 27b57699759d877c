#pragma once

#include <string>

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Of the format of saved states: goes up when a program of the version before could not read what
/// this one writes.
constexpr int kStateVersion = 1;

/// A text without it has been cut short.
constexpr char kLastKey[] = "complete";

/// The text of a state, whatever it holds.
std::string writtenState(const World& world, const State& state);

}  // namespace rigid_body_sim
