#pragma once

#include <string>
#include <vector>

#include "dynamics/methods/step_too_long.hpp"
#include "dynamics/methods/system.hpp"

namespace rigid_body_sim {

/// Advances the states by h, with wrenches that neither start nor end meanwhile. Throws
/// StepTooLong.
using StepFunction = void (*)(const System& system, double h, std::vector<BodyState>& states,
                              Workspace& workspace);

/// What a method may claim; claims add up by |.
enum Claim : unsigned {
  kReversible = 1,    ///< a step of h, then of −h, is back to rounding
  kBoundsEnergy = 2,  ///< the energy error of free motion does not grow with time
  kKeepsFreeL = 4,    ///< angular momentum is constant to the last bit without torque
  kSolves = 8,        ///< the error is rounding, whatever the step
  kRelaxes = 16       ///< drag, however stiff, is followed by its own flow (dragKick)
};

/// One row of the catalogue: a method and what it claims. The tests hold it to every claim.
struct Method {
  const char* name;
  int order;         ///< of attitude and position, for every wrench that it accepts
  int free_order;    ///< of the attitude of a body without torque; 0: exact to rounding
  int evaluations;   ///< of the wrenches, per step
  double most_turn;  ///< [rad] |ω| h that a step follows; longer ones are taken in parts. ω: of a
                     ///< body's rotation, of swings on springs, or the rate of a decay
  double cost;       ///< of a step of one body under one held wrench, relative to strang's
  unsigned claims;   ///< sum of Claim
  unsigned accepts;  ///< sum of Need
  StepFunction step;

  bool claimsTo(Claim claim) const { return (claims & claim) != 0; }
  bool takes(unsigned needs) const { return (needs & ~accepts) == 0; }
};

/// Every method, by ascending order.
const std::vector<Method>& catalogue();

/// The names of the rows that take the needs, for messages: "rk4, dop853".
std::string methodsThatTake(unsigned needs);

/// Throws std::invalid_argument, naming the body, where the row does not take its needs.
void requireTaken(const Method& method, unsigned needs, const std::string& body);

/// The row of that name. Throws std::invalid_argument that lists the names there are.
const Method& methodNamed(const std::string& name);

void semiImplicitEulerStep(const System&, double h, std::vector<BodyState>&, Workspace&);
void strangStep(const System&, double h, std::vector<BodyState>&, Workspace&);
void magnus4Step(const System&, double h, std::vector<BodyState>&, Workspace&);
void rk4Step(const System&, double h, std::vector<BodyState>&, Workspace&);
void kahanLi8Step(const System&, double h, std::vector<BodyState>&, Workspace&);
void blanesMoan6Step(const System&, double h, std::vector<BodyState>&, Workspace&);
void dop853Step(const System&, double h, std::vector<BodyState>&, Workspace&);
void taylorStep(const System&, double h, std::vector<BodyState>&, Workspace&);

}  // namespace rigid_body_sim
