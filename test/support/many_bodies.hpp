#pragma once

#include "support/packed_integrators.hpp"
#include "support/worlds.hpp"

/// Worlds of bodies that do not act on one another.
namespace rigid_body_sim::test {

/// Thrown under gravity: boxes, and every fifth a body of two or three equal moments.
Bench thrownBodies(std::size_t count, unsigned seed = 1);

/// The same without weight and motion, every zero with the sign of the one given.
Bench restingBodies(std::size_t count, double zero);

}  // namespace rigid_body_sim::test
