#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Whether every motion of the world is solved from its start to whatever end, by what it
/// schedules: auto, held wrenches, neither laws nor motors.
bool isSolvedThroughout(const World& world);

/// The bodies of such a world a duration [s] > 0 after its start: what a Simulation with a time
/// step as long has after that step, to rounding and with the same exceptions, for a third of what
/// setting one up costs. start.t must be 0, and nothing else than bodies be there.
std::vector<BodyState> solvedAfter(const World& world, const State& start, double duration);

}  // namespace rigid_body_sim
