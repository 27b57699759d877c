#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Energy, momentum and angular momentum of all bodies together: what they have, or what they
/// exchange with what is around them.
struct Totals {
  double energy = 0;                             ///< [J]
  Vector3d momentum = Vector3d::Zero();          ///< [kg m/s]
  Vector3d angular_momentum = Vector3d::Zero();  ///< [kg m²/s] about the world's origin

  /// Not numbers.
  static Totals unknown();
};

/// What the bodies that move have:
///   mechanicalEnergy,   Σ p,   Σ (x × p + L)
/// Of a body on a pivot p is momentumOf, which the pivot changes, too. Throws std::invalid_argument
/// for a state that cannot be one of the world: of other bodies, laws or actuators, or with changes
/// that the world lacks.
Totals totalsOf(const World& world, const State& state);

}  // namespace rigid_body_sim
