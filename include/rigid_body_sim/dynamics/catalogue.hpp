#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/system.hpp>

namespace rigid_body_sim {

/// Advances the states by h, with wrenches that neither start nor end meanwhile.
using StepFunction = void (*)(const System& system, double h, std::vector<BodyState>& states,
                              Workspace& workspace);

/// A step over which the method cannot follow the motion, in whatever parts.
class StepTooLong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One row of the catalogue: a method and what it claims. The tests hold it to every claim.
struct Method {
  const char* name;
  int order;            ///< of attitude and position, for every wrench that it accepts
  int free_order;       ///< of the attitude of a body without torque
  int evaluations;      ///< of the wrenches, per step
  bool reversible;      ///< a step of h, then of −h, is back to rounding
  bool bounded_energy;  ///< the energy error of free motion does not grow with time
  bool keeps_free_L;    ///< angular momentum is constant to the last bit without torque
  double most_turn;     ///< [rad] |ω| h that a step follows; longer ones are taken in parts
  StepFunction step;
};

/// Every method, by ascending order.
const std::vector<Method>& catalogue();

/// The row of that name. Throws std::invalid_argument that lists the names there are.
const Method& methodNamed(const std::string& name);

void semiImplicitEulerStep(const System&, double h, std::vector<BodyState>&, Workspace&);
void strangStep(const System&, double h, std::vector<BodyState>&, Workspace&);
void magnus4Step(const System&, double h, std::vector<BodyState>&, Workspace&);
void rk4Step(const System&, double h, std::vector<BodyState>&, Workspace&);
void kahanLi8Step(const System&, double h, std::vector<BodyState>&, Workspace&);
void dop853Step(const System&, double h, std::vector<BodyState>&, Workspace&);

}  // namespace rigid_body_sim
