#pragma once

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// A simulation of a world, from its initial state. Where the motion of every body is solved, and
/// nothing that is to come couples them, its time step is the duration [s]: such a motion is
/// evaluated at whatever instant, and each wrench starts and ends at its own, whatever the step.
Simulation quickSimulation(World world, const State& initial, double duration);

/// Whether the motion of every body is solved, and stays so: nothing that is to come couples them.
bool staysSolved(const Simulation& simulation);

}  // namespace rigid_body_sim
