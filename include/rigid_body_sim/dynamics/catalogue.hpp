#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/system.hpp>

namespace rigid_body_sim {

/// Advances the states by h, with wrenches that neither start nor end meanwhile.
using StepFunction = void (*)(const System& system, double h, std::vector<BodyState>& states,
                              Workspace& workspace);

/// One row of the catalogue: a method and what it claims. The tests hold it to every claim.
struct Method {
  const char* name;
  int order;            ///< of attitude and position, for every wrench that it accepts
  int evaluations;      ///< of the wrenches, per step
  bool reversible;      ///< a step of h, then of −h, is back to rounding
  bool bounded_energy;  ///< the energy error of free motion does not grow with time
  bool keeps_free_L;    ///< angular momentum is constant to the last bit without torque
  StepFunction step;
};

/// Every method, cheapest step first.
const std::vector<Method>& catalogue();

/// The row of that name. Throws std::invalid_argument that lists the names there are.
const Method& methodNamed(const std::string& name);

void semiImplicitEulerStep(const System& system, double h, std::vector<BodyState>& states,
                           Workspace& workspace);
void strangStep(const System& system, double h, std::vector<BodyState>& states,
                Workspace& workspace);
void rk4Step(const System& system, double h, std::vector<BodyState>& states, Workspace& workspace);

}  // namespace rigid_body_sim
