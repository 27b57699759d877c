#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

// Motions that need no steps, at equal intervals from the initial state on, in long double: its
// rounding is 2000 times finer than that of what is compared with them.

/// Of bodies that do not act on one another, without laws or drag: by Taylor series. Throws
/// StepTooLong.
std::vector<State> seriesTrack(const World& world, const State& initial, double duration,
                               int instants);

/// Of bodies on which nothing acts but gravity: a parabola and the exact rotation.
std::vector<State> freeTrack(const World& world, const State& initial, double duration,
                             int instants);

}  // namespace rigid_body_sim
