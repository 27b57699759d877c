#pragma once

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// The state at time t, to which the simulation is stepped as far as whole steps go. An instant
/// that a step misses by rounding is that step's.
State stateAt(Simulation& simulation, double t);

}  // namespace rigid_body_sim
