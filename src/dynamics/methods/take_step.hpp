#pragma once

#include "dynamics/methods/catalogue.hpp"

namespace rigid_body_sim {

/// Takes a step of h by an integrator that estimates its error: in equal substeps where the
/// estimate says that it cannot follow so long a step, and where it exceeds workspace.step_bound,
/// until shorter ones no longer help: rounding dominates. Where a force jumps, as that of a spring
/// whose ends pass through one another, the substeps are short there alone. Throws StepTooLong.
void takeControlledStep(const Method& method, const System& system, double h, SystemState& states,
                        Workspace& workspace);

/// Takes a step of h. Throws StepTooLong.
inline void takeStep(const Method& method, const System& system, double h, SystemState& states,
                     Workspace& workspace) {
  if (method.claimsTo(kEstimatesError))
    takeControlledStep(method, system, h, states, workspace);
  else
    method.step(system, h, states, workspace);
}

}  // namespace rigid_body_sim
