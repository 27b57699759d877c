#pragma once

#include "support/worlds.hpp"

/// Small worlds with laws of force in them. Frequencies and rates are a few per second.
namespace rigid_body_sim::test {

/// A box that swings, off its centre, on a spring fixed in the world.
Bench boxOnSpring(double damping = 0);

/// Two bodies that nothing holds but the spring between them.
Bench springPair(double damping = 0);

/// A long body on an eccentric orbit of about 6 s, which it also feels in its attitude.
Bench satellite();

/// A body thrown through a medium.
Bench thrown(const Drag::Coefficients& drag);

/// A body thrown through wind, with drag of every smooth kind behind its centre of mass.
Bench thrownIntoWind();

/// A body that a medium carries at a point above its centre of mass.
Bench afloat();

}  // namespace rigid_body_sim::test
