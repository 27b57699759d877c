#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// The body as a change leaves it. Throws std::invalid_argument where it is fixed, and where the
/// mass properties break a rule.
Body changedBody(const Body& body, const MassProperties& properties_B);

/// Whether a law acts on a body.
bool isMember(const ForceLaw& law, std::size_t body);

/// Whether a body of the law is absent: it does nothing then, and keeps its states.
bool rests(const ForceLaw& law, const World& world);

/// The bodies of a world as they are without its changes.
inline const std::vector<Body>& unchangedBodies(const World& world) {
  return world.unchanged ? world.unchanged->bodies : world.bodies;
}

/// The world as it was given.
World withoutChanges(World world);

/// Gives in the principal frame of a body that has been changed what a wrench has in that before,
/// or at its centre of mass.
void reframe(PointWrench& wrench, std::size_t body, const Body& before, const Body& after);

/// The state of a body that is where it was, with the momentum that it had, after its mass
/// properties have changed: p, and L about the world's origin, so that with d from the centre of
/// mass before to that after
///   L_W' = L_W − d × p.
/// Where the centre stays, p and L_W keep their bits; of a body on a pivot L about the pivot does.
BodyState keepingMomentum(const Body& before, const Body& after, const BodyState& state);

}  // namespace rigid_body_sim
