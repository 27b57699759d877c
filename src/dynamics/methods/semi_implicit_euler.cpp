#include "dynamics/methods/kick_drift.hpp"

namespace rigid_body_sim {

// The update of the source lecture, in its order (Rotenberg, "Rigid Body Motion",
// RigidBody::Update):
//   p += f h,  x += p/m h,  L += τ h,  ω = I⁻¹ L with I = A I₀ Aᵀ,  A turned by |ω| h about ω
// ω is computed, and A turned about it, in the axes of the body: I₀ is diagonal there.
// Drag, which the lecture does not have, slows p and L down by its exact flow.
void semiImplicitEulerStep(const System& system, double h, SystemState& states,
                           Workspace& workspace) {
  evaluateWrenches(system, states, workspace);
  methods::kickAll(system, h, workspace.wrenches, states.bodies);
  const methods::LawDrift laws(system, states);
  for (std::size_t i = 0; i < states.bodies.size(); ++i) {
    const Body& body = *system.bodies[i];
    BodyState& s = states.bodies[i];
    driftPosition(body.mass, h, s);
    driftAlongOmega(body.inv_I, h, s);
  }
  laws.finish(system, h, states);
  workspace.wrenches_current = false;
}

}  // namespace rigid_body_sim
