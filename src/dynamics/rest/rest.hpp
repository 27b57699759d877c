#pragma once

#include <optional>

#include "dynamics/methods/system.hpp"

namespace rigid_body_sim {

/// Finds whether bodies in contact have come to rest for good: whether it is certain that from now
/// on none of them strays by more than a tenth of the tolerance from where they would stand still.
///
/// The proof: as long as no law switches its mode, laws that hold still (ForceLaw::holdsStill) take
/// energy out of the motion and never put any in. So the bodies stay where the potential energy is
/// no greater than what the motion has now, kinetic and potential, above its least: within
/// √(2 E/λ) of it along each mode of vibration. What no force brings back, such as the spin of a
/// ball about the normal, goes on at its speed. Within these bounds, doubled, no law switches.
class RestSearch {
 public:
  /// attitude: of the bound on errors [rad]; on errors of position, relative to radii of gyration.
  RestSearch(double attitude, double horizon) : limit_(0.1 * attitude), horizon_(horizon) {}

  /// The states at rest; nothing where rest is not certain. fastest: a rate of the system [1/s]
  /// that none of its swings exceeds.
  std::optional<SystemState> rest(const System& system, const SystemState& states,
                                  double fastest) const;

 private:
  bool mayRest(const System& system, const SystemState& states, double fastest) const;

  double limit_;
  double horizon_;  // [s]
};

}  // namespace rigid_body_sim
