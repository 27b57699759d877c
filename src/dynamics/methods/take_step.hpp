#pragma once

#include "dynamics/methods/catalogue.hpp"

namespace rigid_body_sim {

/// Takes a step of h. An integrator that estimates its error takes it in equal parts where the
/// estimate says that it cannot follow so long a step, and where it exceeds workspace.step_bound,
/// until shorter ones no longer help: rounding dominates. Throws StepTooLong.
void takeStep(const Method& method, const System& system, double h, SystemState& states,
              Workspace& workspace);

}  // namespace rigid_body_sim
