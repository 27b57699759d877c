#pragma once

#include <string>
#include <vector>

#include "dynamics/methods/system.hpp"
#include "dynamics/step_too_long.hpp"

namespace rigid_body_sim {

/// Advances the states by h, with wrenches that neither start nor end meanwhile. Throws
/// StepTooLong.
using StepFunction = void (*)(const System& system, double h, SystemState& states,
                              Workspace& workspace);

/// What a method may claim; claims add up by |.
enum Claim : unsigned {
  kReversible = 1,       ///< a step of h, then of −h, is back to rounding
  kBoundsEnergy = 2,     ///< the energy error of free motion does not grow with time
  kKeepsFreeL = 4,       ///< angular momentum is constant to the last bit without torque
  kSolves = 8,           ///< the error is rounding, whatever the step
  kEstimatesError = 16,  ///< a step leaves its error in Workspace::error, and is not done where
                         ///< that is infinite
  kFeedsLeastAxis = 32   ///< a component of L along the axis of least inertia grows at the rate
                         ///< ½ h (ω·L/I₁ − |ω|²)
};

/// An integrator and what it claims. The tests check every claim.
struct Method {
  const char* name;
  int order;           ///< of attitude and position, for every wrench that it supports
  int free_order;      ///< of the attitude of a body without torque; 0: exact to rounding
  int evaluations;     ///< of the wrenches, per step
  double max_turn;     ///< Largest |ω| h [rad] per substep. ω: of a body's rotation, of swings on
                       ///< springs, or the rate of a decay
  double cost;         ///< of a step of one body under one held wrench, relative to strang's
  unsigned claims;     ///< sum of Claim
  unsigned supported;  ///< sum of Need
  StepFunction step;

  bool claimsTo(Claim claim) const { return (claims & claim) != 0; }
  bool supports(unsigned needs) const { return (needs & ~supported) == 0; }
};

/// Every method, by ascending order.
const std::vector<Method>& catalogue();

/// The names of those that support the needs, for messages: "rk4, dop853".
std::string methodsThatSupport(unsigned needs);

/// Throws std::invalid_argument where the method does not support the needs of a body; the message
/// names it and the methods that support all of the world's needs.
void requireSupport(const Method& method, unsigned needs, const std::string& body,
                    unsigned needs_of_world = 0);

/// The method of that name. Throws std::invalid_argument that lists the names there are.
const Method& methodNamed(const std::string& name);

/// The steps of the entries, by their names; each file says what its integrator does.
void semiImplicitEulerStep(const System&, double h, SystemState&, Workspace&);
void strangStep(const System&, double h, SystemState&, Workspace&);
void magnus4Step(const System&, double h, SystemState&, Workspace&);
void rk4Step(const System&, double h, SystemState&, Workspace&);
void kahanLi8Step(const System&, double h, SystemState&, Workspace&);
void blanesMoan6Step(const System&, double h, SystemState&, Workspace&);
void dop853Step(const System&, double h, SystemState&, Workspace&);
void taylorStep(const System&, double h, SystemState&, Workspace&);

}  // namespace rigid_body_sim
