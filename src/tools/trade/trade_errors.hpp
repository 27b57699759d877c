#pragma once

#include <algorithm>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// How far one computed motion is from another, each the worst of all bodies and instants.
struct Errors {
  double attitude = 0;          ///< [rad]
  double position = 0;          ///< relative to the path flown so far, see errorsOf
  double energy = 0;            ///< of all bodies, relative to the greatest kinetic energy
  double angular_momentum = 0;  ///< of a body about its centre of mass, relative to its greatest

  /// What a tolerance bounds (SolverOptions::tolerance).
  double bounded() const { return std::max(attitude, position); }
};

/// The greater of each.
inline Errors worst(const Errors& a, const Errors& b) {
  return {std::max(a.attitude, b.attitude), std::max(a.position, b.position),
          std::max(a.energy, b.energy), std::max(a.angular_momentum, b.angular_momentum)};
}

/// The errors of a track against the truth: states at the same instants, the first of both the
/// initial state. What rounding of a body's size, and of forces that cancel its weight, makes of
/// its place is no error: the path of one that hovers is no longer than that. The scale of the
/// energy is at least what the bodies gain by falling by their radii of gyration, that of an
/// angular momentum at least what the body has without its wheels. A quantity whose scale is zero
/// counts as it is.
Errors errorsOf(const World& world, const std::vector<State>& track,
                const std::vector<State>& truth);

}  // namespace rigid_body_sim
