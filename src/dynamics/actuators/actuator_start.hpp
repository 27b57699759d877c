#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Whether any body of the world has actuators.
bool hasActuators(const World& world);

/// The state with those of the actuators: where it has none, they start at its time, and L_W gains
/// the momentum of wheels and rotors.
State withActuators(const World& world, State state);

/// What a body's L_W is, wheels and rotors included: R (L_P + H).
Vector3d totalMomentum(const BodyState& state, const Vector3d& H_P);

}  // namespace rigid_body_sim
